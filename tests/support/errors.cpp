#include "support/errors.h"

namespace gg::test {

::testing::AssertionResult fails_with(ExitCode code, const std::vector<std::string>& parts,
                                      const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    const std::string text = error.what();
    if (error.code() != code)
      return ::testing::AssertionFailure()
             << "exit code " << static_cast<int>(error.code()) << " instead of "
             << static_cast<int>(code) << ": " << text;
    for (const std::string& part : parts)
      if (text.find(part) == std::string::npos)
        return ::testing::AssertionFailure() << "no \"" << part << "\" in: " << text;
    return ::testing::AssertionSuccess();
  } catch (const std::exception& error) {
    return ::testing::AssertionFailure() << "an exception that is no gg::Error: " << error.what();
  }
  return ::testing::AssertionFailure() << "no error";
}

} // namespace gg::test
