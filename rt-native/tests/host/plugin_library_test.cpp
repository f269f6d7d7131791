#include "robotui/rt/host/plugin_library.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "robotui/rt/host/hosted_plugin.h"

namespace robotui::rt::host {
namespace {

const std::vector<std::filesystem::path> kFolders{"/nowhere", RT_PLUGINS};

std::string refusal(const std::string& type, PluginKind kind = PluginKind::kControl) {
  try {
    PluginLibrary(type, kFolders).create(kind);
  } catch (const PluginError& e) {
    return e.what();
  }
  return "nothing was refused";
}

void expectIn(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(PluginLibrary, MakesAPlugin) {
  const PluginLibrary library("Naughty", kFolders);
  EXPECT_NE(library.create(PluginKind::kControl), nullptr);
}

TEST(PluginLibrary, NamesTheFoldersWhereALibraryIsMissing) {
  expectIn(refusal("Nothing"), "There is no libNothing.so in /nowhere, ");
  expectIn(refusal("Nothing"), "ROBOTUI_RT_PLUGINS");
  expectIn(refusal("../evil"), "no name of a plugin");
}

TEST(PluginLibrary, NamesBothVersionsOfAWrongInterface) {
  expectIn(refusal("WrongAbi"), "version 999 of the plugin interface, and this is version 3");
}

TEST(PluginLibrary, TakesOneThatWasBuiltAsTheHostWas) {
  EXPECT_NE(PluginLibrary("Plain", kFolders).create(PluginKind::kControl), nullptr);
}

// The sentence names both sides and the remedy, also where the loader would only have named a symbol that is missing.
TEST(PluginLibrary, RefusesOneThatWasBuiltAnotherWayAndNamesBothSides) {
  expectIn(
      refusal("OtherStrings"),
      "libOtherStrings.so does not fit this program: it was built with _GLIBCXX_USE_CXX11_ABI 0, and this program with "
      "_GLIBCXX_USE_CXX11_ABI 1. Build it again with the same _GLIBCXX_USE_CXX11_ABI.");
  expectIn(refusal("OtherAlignment"),
           "it was built with Eigen alignment 64 bytes, and this program with Eigen alignment " +
               std::to_string(EIGEN_MAX_ALIGN_BYTES) + " bytes. Build it again with the same -march");
  expectIn(refusal("OtherCompiler"), "it was built with compiler GCC 99, and this program with compiler ");
  expectIn(refusal("OtherCompiler"), "Build it again with the compiler of this program.");
}

TEST(PluginLibrary, SaysWhatALibraryLacks) {
  expectIn(refusal("NoSymbols"), "end its source with ROBOTUI_RT_PLUGIN(NoSymbols)");
}

TEST(PluginLibrary, SaysWhatAConstructorThrew) { expectIn(refusal("ThrowingConstructor"), "threw: no hardware key"); }

TEST(PluginLibrary, KnowsAnIoPluginFromAControlPlugin) {
  expectIn(refusal("Greeter"), "is an IO plugin: name it under io_plugins");
  expectIn(refusal("Naughty", PluginKind::kIo), "is no IO plugin");
}

TEST(PluginLibrary, SaysWhyAFileCannotBeLoaded) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("robotui-library-test-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "libText.so") << "no library";
  try {
    PluginLibrary("Text", {folder});
    ADD_FAILURE();
  } catch (const PluginError& e) {
    expectIn(e.what(), "cannot be loaded");
  }
  std::filesystem::remove_all(folder);
}

TEST(PluginLibrary, IsGoneFromMemoryWhenItIsUnloaded) {
  PluginLibrary library("Naughty", kFolders);
  library.create(PluginKind::kControl);
  EXPECT_TRUE(library.unload());
}

}  // namespace
}  // namespace robotui::rt::host
