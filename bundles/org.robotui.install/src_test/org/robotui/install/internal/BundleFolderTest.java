package org.robotui.install.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.osgi.framework.Bundle;
import org.osgi.framework.Constants;
import org.osgi.framework.launch.FrameworkFactory;

/** In a framework of its own, as nothing else says what a framework does with jars that come and go. */
final class BundleFolderTest {
  private static final String NAME = "org.example.lidar";

  @TempDir
  private Path room;
  private Path folder;
  private org.osgi.framework.launch.Framework framework;
  private BundleFolder watched;
  private final List<String> said = new ArrayList<>();
  private final List<String> troubles = new ArrayList<>();

  @BeforeEach
  void begin() throws Exception {
    folder = Files.createDirectory(room.resolve("bundles"));
    framework = ServiceLoader.load(FrameworkFactory.class).findFirst().orElseThrow()
        .newFramework(Map.of(Constants.FRAMEWORK_STORAGE, room.resolve("storage").toString()));
    framework.start();
    watched = folderOf();
  }

  private BundleFolder folderOf() {
    return new BundleFolder(folder, room.resolve("copies"), new Framework(framework.getBundleContext()),
        (sentence, trouble) -> (trouble ? troubles : said).add(sentence));
  }

  @AfterEach
  void end() throws Exception {
    watched.close();
    framework.stop();
    framework.waitForStop(10_000);
  }

  private Path jar(String file, String version, Map<String, String> headers) throws IOException {
    Manifest manifest = new Manifest();
    Attributes attributes = manifest.getMainAttributes();
    attributes.put(Attributes.Name.MANIFEST_VERSION, "1.0");
    attributes.putValue(Constants.BUNDLE_MANIFESTVERSION, "2");
    attributes.putValue(Constants.BUNDLE_VERSION, version);
    headers.forEach(attributes::putValue);
    Path jar = folder.resolve(file);
    try (OutputStream out = Files.newOutputStream(jar); JarOutputStream zip = new JarOutputStream(out, manifest)) {
      zip.finish();
    }
    return settled(jar);
  }

  private Path jar(String file, String version) throws IOException {
    return jar(file, version, Map.of(Constants.BUNDLE_SYMBOLICNAME, NAME));
  }

  /** As if it had been written a while ago. */
  private static Path settled(Path jar) throws IOException {
    Files.setLastModifiedTime(jar, FileTime.from(Instant.now().minusSeconds(60)));
    return jar;
  }

  /** However long the test takes. */
  private static void writtenNow(Path jar) throws IOException {
    Files.setLastModifiedTime(jar, FileTime.from(Instant.now().plusSeconds(60)));
  }

  private Optional<Bundle> bundle(String name) {
    return Arrays.stream(framework.getBundleContext().getBundles()).filter(b -> name.equals(b.getSymbolicName()))
        .findFirst();
  }

  private String running() {
    return bundle(NAME).filter(b -> b.getState() == Bundle.ACTIVE).map(b -> b.getVersion().toString()).orElse("none");
  }

  @Test
  void aJarIsStartedReplacedAndRemoved() throws Exception {
    Path jar = jar("lidar.jar", "1.0.0");
    watched.scan();
    assertEquals("1.0.0", running());

    jar("lidar.jar", "2.0.0");
    Files.setLastModifiedTime(jar, FileTime.from(Instant.now().minusSeconds(30)));
    watched.scan();
    assertEquals("2.0.0", running());

    Files.delete(jar);
    watched.scan();
    assertTrue(bundle(NAME).isEmpty());
    assertEquals(List.of("Installed org.example.lidar 1.0.0 from " + jar + ".",
        "Installed org.example.lidar 2.0.0 from " + jar + ".",
        "Removed org.example.lidar 2.0.0: lidar.jar has gone."), said);
    assertEquals(List.of(), troubles);
  }

  @Test
  void aJarThatIsBeingWrittenIsWaitedFor() throws Exception {
    Path jar = jar("lidar.jar", "1.0.0");
    byte[] whole = Files.readAllBytes(jar);
    writtenNow(Files.write(jar, Arrays.copyOf(whole, whole.length / 2)));
    watched.scan();
    writtenNow(Files.write(jar, whole));
    watched.scan();
    assertEquals("none", running());

    watched.scan();

    assertEquals("1.0.0", running());
    assertEquals(List.of(), troubles);
  }

  @Test
  void aJarThatIsNotWholeIsSaidOnceAndWhatItWasGoesOn() throws Exception {
    Path jar = jar("lidar.jar", "1.0.0");
    watched.scan();
    settled(Files.writeString(jar, "no jar"));
    watched.scan();
    watched.scan();

    assertEquals("1.0.0", running());
    assertEquals(1, troubles.size());
    assertTrue(troubles.getFirst().startsWith(jar + " is no whole jar"), troubles.getFirst());

    Files.setLastModifiedTime(jar("lidar.jar", "1.1.0"), FileTime.from(Instant.now().minusSeconds(10)));
    watched.scan();
    assertEquals("1.1.0", running());
    assertEquals(List.of(), watched.troubles());
  }

  @Test
  void aJarThatIsNoBundleIsSaid() throws Exception {
    jar("plain.jar", "1.0.0", Map.of());

    watched.scan();

    assertTrue(troubles.getFirst().contains("plain.jar is no bundle"), troubles.getFirst());
  }

  @Test
  void whatIsMissingIsNamedUntilAnotherJarBringsIt() throws Exception {
    jar("user.jar", "1.0.0", Map.of(Constants.BUNDLE_SYMBOLICNAME, NAME, Constants.IMPORT_PACKAGE,
        "org.example.base;version=\"[1.0,2.0)\""));
    watched.scan();
    assertTrue(troubles.getFirst().contains("it needs the package org.example.base in version [1.0"),
        troubles.getFirst());

    jar("base.jar", "1.0.0", Map.of(Constants.BUNDLE_SYMBOLICNAME, "org.example.base", Constants.EXPORT_PACKAGE,
        "org.example.base;version=\"1.0\""));
    watched.scan();

    assertEquals("1.0.0", running());
    assertEquals(List.of(), watched.troubles());
  }

  @Test
  void theSameBundleTwiceIsRefused() throws Exception {
    jar("a.jar", "1.0.0");
    jar("b.jar", "2.0.0");

    watched.scan();

    assertEquals(1, troubles.size());
    assertTrue(troubles.getFirst().contains("is installed already"), troubles.getFirst());
  }

  @Test
  void whatAnotherHandUninstalledComesBack() throws Exception {
    jar("lidar.jar", "1.0.0");
    watched.scan();
    bundle(NAME).orElseThrow().uninstall();

    watched.scan();

    assertEquals("1.0.0", running());
  }

  @Test
  void nothingOfARunThatWasKilledIsLeft() throws Exception {
    Path jar = jar("lidar.jar", "1.0.0");
    watched.scan();
    Files.delete(jar);

    BundleFolder next = folderOf();
    next.clear();

    assertTrue(bundle(NAME).isEmpty());
    try (var copies = Files.list(room.resolve("copies"))) {
      assertFalse(copies.findAny().isPresent());
    }
  }
}
