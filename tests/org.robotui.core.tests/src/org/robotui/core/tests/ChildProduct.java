package org.robotui.core.tests;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.osgi.framework.Bundle;

/**
 * The headless product in a process of its own, made of the bundles of this framework and the one that misbehaves, with
 * as little memory as a test likes.
 */
final class ChildProduct implements AutoCloseable {
  private static final Set<String> STARTED =
      Set.of("org.apache.felix.scr", "org.eclipse.equinox.common", "org.eclipse.core.runtime",
          "org.eclipse.equinox.app");
  private static final long END_SECONDS = 60;

  private final Path out;
  private final Path err;
  private final Process process;

  ChildProduct(Path folder, String yaml, String... vmOptions) throws Exception {
    Path bad = Files.write(folder.resolve(BadBundle.NAME + ".jar"), BadBundle.packed().jar());
    Path configuration = Files.createDirectories(folder.resolve("configuration"));
    Files.writeString(configuration.resolve("config.ini"),
        "osgi.bundles=" + bundles(bad) + "\nosgi.bundles.defaultStartLevel=4\n"
            + "osgi.framework=" + Bundles.file("org.eclipse.osgi").toUri() + "\nosgi.instance.area.default=@none\n");
    Path config = Files.writeString(folder.resolve("child.yaml"), yaml);
    out = folder.resolve("out");
    err = folder.resolve("err");
    List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
    command.addAll(List.of(vmOptions));
    command.addAll(List.of("-Drobotui.state=" + folder.resolve("state"), "-Drobotui.log=" + folder.resolve("log"),
        "-Dlogback.configurationFile=" + Path.of(System.getenv("ROBOTUI_ROOT"),
            "features/org.robotui.feature.platform.headless/rootfiles/logback.xml").toUri(),
        "-jar", Bundles.file("org.eclipse.equinox.launcher").toString(), "-configuration", configuration.toString(),
        "-install", folder.toString(), "-application", "org.robotui.headless.application", "-json", "-config",
        config.toString()));
    process = new ProcessBuilder(command).redirectOutput(out.toFile()).redirectError(err.toFile()).start();
  }

  private static String bundles(Path bad) {
    List<String> all = Arrays.stream(Bundles.context().getBundles())
        .filter(b -> b.getBundleId() != 0 && !isOfTests(b.getSymbolicName()) && (isOurs(b) || !isFragment(b)))
        .map(ChildProduct::entry).collect(Collectors.toCollection(ArrayList::new));
    all.add("reference:" + bad.toUri() + "@start");
    return String.join(",", all);
  }

  private static boolean isOfTests(String name) {
    return name.contains("junit") || name.contains("opentest4j") || name.contains("surefire") || name.endsWith(".tests")
        || name.contains(".swt") || name.equals(BadBundle.NAME);
  }

  private static String entry(Bundle bundle) {
    String name = bundle.getSymbolicName();
    String start = STARTED.contains(name) ? "@2:start" : isOurs(bundle) && !isFragment(bundle) ? "@start" : "";
    return "reference:" + Bundles.file(name).toUri() + start;
  }

  private static boolean isOurs(Bundle bundle) {
    return bundle.getSymbolicName().startsWith("org.robotui.");
  }

  private static boolean isFragment(Bundle bundle) {
    return bundle.getHeaders().get("Fragment-Host") != null;
  }

  /** Waits for words on its standard error. */
  void awaitError(String words) {
    Eventually.await("it says " + words, () -> text(err).contains(words), () -> text(err) + "\n" + tail(out));
  }

  String errors() {
    return text(err);
  }

  /** Waits until it has said more on its standard output: until it lives on. */
  void awaitMore() {
    long before = out.toFile().length();
    Eventually.await("it goes on", () -> out.toFile().length() > before + 500, () -> text(err));
  }

  static String text(Path file) {
    try {
      return Files.exists(file) ? new String(Files.readAllBytes(file), StandardCharsets.UTF_8) : "";
    } catch (IOException e) {
      return e.toString();
    }
  }

  private static String tail(Path file) {
    String text = text(file);
    return text.substring(Math.max(0, text.length() - 1000));
  }

  /** Ends it as a user does, and says with which code it ended. */
  int end() throws InterruptedException {
    process.destroy();
    if (!process.waitFor(END_SECONDS, TimeUnit.SECONDS)) {
      process.destroyForcibly().waitFor();
    }
    return process.exitValue();
  }

  @Override
  public void close() throws InterruptedException {
    process.destroyForcibly().waitFor();
  }
}
