package org.robotui.urdf.pack;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PackageFoldersTest {
  @TempDir
  private Path folder;
  private PackageFolders folders;

  @BeforeEach
  void layOut() throws IOException {
    Files.createDirectories(folder.resolve("src/arm/meshes"));
    Files.writeString(folder.resolve("src/arm/meshes/a b.stl"), "mesh");
    Files.createDirectories(folder.resolve("src/stack/deep"));
    Files.writeString(folder.resolve("src/stack/deep/package.xml"), "<package><name>wheels</name></package>");
    Files.writeString(folder.resolve("src/stack/deep/w.obj"), "w");
    Files.writeString(folder.resolve("secret"), "hidden");
    Files.createSymbolicLink(folder.resolve("src/arm/out.stl"), folder.resolve("secret"));
    Files.createSymbolicLink(folder.resolve("src/arm/in.stl"), folder.resolve("src/arm/meshes/a b.stl"));
    folders = new PackageFolders(List.of(folder.resolve("none"), folder.resolve("src")));
  }

  private static PackageFile.Found found(PackageFile file) {
    return assertInstanceOf(PackageFile.Found.class, file, file.toString());
  }

  @Test
  void findsPackagesInARootAndDeeperByTheirManifestAndARootThatIsOne() throws IOException {
    assertArrayEquals("mesh".getBytes(), found(folders.find("package://arm/meshes/a%20b.stl")).bytes());
    assertArrayEquals("mesh".getBytes(), found(folders.find("package://arm/meshes/a b.stl")).bytes());
    assertEquals("w.obj", found(folders.find("package://wheels/w.obj")).file().getFileName().toString());
    found(new PackageFolders(List.of(folder.resolve("src/arm"))).find("package://arm/meshes/a b.stl"));
    found(folders.find("package://arm/in.stl"));
  }

  @Test
  void followsLinksOfPackagesAndFromOneRootToAnother() throws IOException {
    Files.createDirectories(folder.resolve("elsewhere/legs/meshes"));
    Files.writeString(folder.resolve("elsewhere/legs/meshes/l.stl"), "leg");
    Files.createSymbolicLink(folder.resolve("src/legs"), folder.resolve("elsewhere/legs"));
    Files.createDirectories(folder.resolve("install/share/arm/meshes"));
    Files.createSymbolicLink(folder.resolve("install/share/arm/meshes/a.stl"),
        folder.resolve("src/arm/meshes/a b.stl"));
    Files.createSymbolicLink(folder.resolve("workspace"), folder.resolve("src"));

    found(folders.find("package://legs/meshes/l.stl"));
    found(new PackageFolders(List.of(folder.resolve("workspace"))).find("package://arm/meshes/a b.stl"));
    Path installed = folder.resolve("install/share");
    found(new PackageFolders(List.of(installed, folder.resolve("src"))).find("package://arm/meshes/a.stl"));
    PackageFile alone = new PackageFolders(List.of(installed)).find("package://arm/meshes/a.stl");
    String why = assertInstanceOf(PackageFile.Refused.class, alone).why();
    assertTrue(why.contains("or add the folder " + folder.toRealPath().resolve("src/arm/meshes")), why);
  }

  @Test
  void findsFilesByTheirPathWithinRootsOnly() {
    found(folders.find("file://" + folder.resolve("src/arm/meshes/a b.stl")));
    assertTrue(refused("file://" + folder.resolve("secret")).contains("lies outside of the folders of packages"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"package://arm/../../secret", "package://arm/meshes/../../../secret",
      "package://arm/%2e%2e/%2e%2e/secret",
      "package://arm/out.stl", "package://arm//../../secret"})
  void followsNothingOutOfAPackage(String uri) {
    assertTrue(refused(uri).contains("leads out of its package"), refused(uri));
  }

  @ParameterizedTest
  @ValueSource(strings = {"http://host/a.stl", "https://host/a.stl", "ftp://host/a.stl", "a.stl", "/etc/hostname",
      "jar:file:/a!/b", ""})
  void fetchesNothingFromElsewhere(String uri) {
    assertTrue(refused(uri).contains("must be package://"), refused(uri));
  }

  @ParameterizedTest
  @ValueSource(strings = {"package://", "package://arm", "package://../secret", "package://./secret",
      "package:///secret"})
  void wantsAPackageAndAFile(String uri) {
    assertTrue(refused(uri).contains("names no file"), refused(uri));
  }

  @Test
  void saysWhatIsMissing() {
    assertTrue(refused("package://legs/a.stl").contains("the package 'legs' is not in"));
    assertTrue(refused("package://arm/meshes/none.stl").contains("there is no file"));
    assertTrue(refused("package://arm/meshes").contains("is no file"));
    assertTrue(refused("package://arm/a\u0000b").contains("cannot be read"));
  }

  @Test
  void readsBesideAFileWithinItsPackageOnly() {
    PackageFile.Found mesh = found(folders.find("package://arm/meshes/a b.stl"));
    found(folders.beside(mesh, "../meshes/a b.stl"));
    assertInstanceOf(PackageFile.Refused.class, folders.beside(mesh, "../../../secret"));
    assertInstanceOf(PackageFile.Refused.class, folders.beside(mesh, folder.resolve("secret").toString()));
  }

  @Test
  void splitsPathsAsRosWritesThem() {
    assertEquals(List.of(Path.of("/a"), Path.of("/b/c")), PackageFolders.split("/a:relative::/b/c/"));
  }

  private String refused(String uri) {
    return assertInstanceOf(PackageFile.Refused.class, folders.find(uri)).why();
  }
}
