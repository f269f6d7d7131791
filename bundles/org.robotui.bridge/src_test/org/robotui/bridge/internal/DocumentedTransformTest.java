package org.robotui.bridge.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.bridge.BridgeTransform;
import org.robotui.api.bridge.BridgeTransform.Direction;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.sensor.Battery;

/** The transform of {@code docs/bridges.md}, compiled and used as it stands there. */
class DocumentedTransformTest {
  private static final Pattern CODE = Pattern.compile("```java\n(package .*?)```", Pattern.DOTALL);
  private static final Pattern MANIFEST = Pattern.compile("```manifest\n(.*?)```", Pattern.DOTALL);
  private static final Pattern IMPORTED = Pattern.compile("import (org\\.robotui\\.[a-z0-9.]+)\\.[A-Z]");
  private static final Pattern PACKAGE = Pattern.compile("[a-z0-9]+(\\.[a-z0-9]+)+(?=;version)");
  private static final String ANNOTATION = """
      package org.osgi.service.component.annotations;
      public @interface Component {
        Class<?>[] service();
      }
      """;
  private static final String NAME = "acme.charge.internal.ChargeSpeedTransform";

  private final String text = read();

  DocumentedTransformTest() throws IOException {
    // the document is read in its field
  }

  private static String read() throws IOException {
    Stream<Path> places = Stream.concat(Optional.ofNullable(System.getenv("ROBOTUI_ROOT")).stream().map(Path::of),
        Stream.of(Path.of(""), Path.of("../..")));
    Path document = places.map(place -> place.toAbsolutePath().resolve("docs/bridges.md")).filter(Files::isRegularFile)
        .findFirst().orElseThrow();
    return Files.readString(document);
  }

  private String block(Pattern pattern) {
    return pattern.matcher(text).results().map(found -> found.group(1)).findFirst().orElseThrow();
  }

  @Test
  void itCompilesAndMakesSpeedOfCharge(@TempDir Path folder) throws Exception {
    compile(folder);
    try (URLClassLoader loader = new URLClassLoader(new URL[]{folder.toUri().toURL()}, getClass().getClassLoader())) {
      BridgeTransform transform =
          (BridgeTransform) loader.loadClass(NAME).getDeclaredConstructor().newInstance();
      Battery half = new Battery(12, 1, 0.5, Battery.Status.DISCHARGING);
      assertTrue(text.contains("transform: " + transform.id()), "the configuration names it");
      assertEquals(Optional.of(VelocityCommand.planar(0.25, 0)), transform.apply(half, Direction.FORTH));
      assertThrows(IllegalArgumentException.class, () -> transform.apply(half, Direction.BACK));
    }
  }

  @Test
  void itsManifestImportsWhatItUses() {
    assertEquals(all(IMPORTED, block(CODE), 1), all(PACKAGE, block(MANIFEST), 0));
  }

  private static Set<String> all(Pattern pattern, String where, int group) {
    return pattern.matcher(where).results().map(found -> found.group(group)).collect(Collectors.toSet());
  }

  /** The annotation is read by builds of bundles alone, so that it need not be where tests run. */
  private void compile(Path folder) throws IOException {
    Path source = Files.writeString(folder.resolve("ChargeSpeedTransform.java"), block(CODE));
    Path annotation = Files.writeString(folder.resolve("Component.java"), ANNOTATION);
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter said = new StringWriter();
    try (StandardJavaFileManager manager = compiler.getStandardFileManager(null, null, null)) {
      boolean done = compiler.getTask(said, manager, null, List.of("-proc:none", "-d", folder.toString()), null,
          manager.getJavaFileObjects(source, annotation)).call();
      assertTrue(done, said::toString);
    }
  }
}
