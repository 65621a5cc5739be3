"""Materials, each as glTF for us, as a BSDF of Mitsuba's, and what is inside."""
import numpy as np

GOLD = {"n": [0.14, 0.43, 1.38], "k": [3.697, 2.455, 1.914]}  # of our preset `gold`


def glass(alpha, distribution="ggx", color=None, distance=None):
    gltf = {
        "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
        "extensions": {
            "KHR_materials_transmission": {"transmissionFactor": 1},
            "KHR_materials_volume": {"thicknessFactor": 1},
            "KHR_materials_ior": {"ior": 1.5},
        },
        "extras": {"groundglass": {"alpha": alpha, "distribution": distribution}},
    }
    bsdf = {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0}
    if alpha > 0:
        bsdf = {"type": "roughdielectric", "int_ior": 1.5, "ext_ior": 1.0, "alpha": alpha, "distribution": distribution}
    interior = None
    if color:
        gltf["extensions"]["KHR_materials_volume"] |= {"attenuationColor": color, "attenuationDistance": distance}
        interior = [float(s) for s in -np.log(color) / distance]  # absorption per metre, of each channel
    return {"gltf": gltf, "bsdf": bsdf, "interior": interior}


def diffuse(grey):
    # specularFactor 0: a coat that reflects nothing, so Lambert's law alone.
    return {
        "gltf": {
            "pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [grey, grey, grey, 1]},
            "extensions": {"KHR_materials_specular": {"specularFactor": 0}},
        },
        "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": grey}},
        "interior": None,
    }


def gold(alpha, distribution="ggx"):
    # Seen and met from both sides: the model has holes, and what is behind them must be the same.
    return {
        "gltf": {"doubleSided": True, "extras": {"groundglass": {"preset": "gold", "alpha": alpha, "distribution": distribution}}},
        "bsdf": {
            "type": "twosided",
            "bsdf": {
                "type": "roughconductor",
                "alpha": alpha,
                "distribution": distribution,
                "eta": {"type": "rgb", "value": GOLD["n"]},
                "k": {"type": "rgb", "value": GOLD["k"]},
            },
        },
        "interior": None,
    }


def brushed_gold(across, strength):
    """Brushed along longitude. Widths as KHR_materials_anisotropy has them."""
    material = gold(across)
    material["gltf"]["extras"]["groundglass"]["anisotropy"] = strength
    metal = material["bsdf"]["bsdf"]
    del metal["alpha"]
    metal |= {"alpha_u": across + (1 - across) * strength**2, "alpha_v": across}
    return material
