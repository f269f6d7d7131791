package org.robotui.testkit.recorded;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Finds the recordings, maps and models that are shared beside the repository, in the folder that
 * {@code ROBOTUI_SHARED} names. A test that needs them:
 * {@code @EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)}.
 */
public final class SharedData {
  /** The name of the condition as JUnit wants it. */
  public static final String AVAILABLE = "org.robotui.testkit.recorded.SharedData#available";

  /** What is shown where a test is skipped. */
  public static final String REASON =
      "no shared data: ROBOTUI_SHARED names no folder, and none lies beside the repository";

  private SharedData() {}

  /**
   * Whether there are shared data.
   *
   * @return true where their folder is found
   */
  public static boolean available() {
    return folder().isPresent();
  }

  /**
   * One file or folder.
   *
   * @param name below the folder of the data, for example {@code bags/sena_loop.bag}
   * @return the file, which may be absent
   */
  public static Path file(String name) {
    return folder().orElseThrow(() -> new IllegalStateException(REASON)).resolve(name);
  }

  /**
   * What was recorded of a network.
   *
   * @param name below the folder of these, for example {@code player/rangers.s2c.bin}
   * @return the file, which may be absent
   */
  public static Path capture(String name) {
    return folder().orElseThrow(() -> new IllegalStateException(REASON)).resolveSibling("captures").resolve(name);
  }

  /**
   * All files of a kind.
   *
   * @param folder below the folder of the data, for example {@code bags}
   * @param ending of their names, for example {@code .bag}
   * @return them, by name
   */
  public static List<Path> files(String folder, String ending) {
    try (Stream<Path> files = Files.walk(file(folder))) {
      return files.filter(file -> file.toString().endsWith(ending)).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Optional<Path> folder() {
    return Optional.ofNullable(System.getenv("ROBOTUI_SHARED")).map(Path::of)
        .or(() -> repository().map(root -> root.resolveSibling("shared")))
        .map(shared -> shared.resolve("data")).filter(Files::isDirectory);
  }

  private static Optional<Path> repository() {
    Path folder = Path.of("").toAbsolutePath();
    while (folder != null && !Files.isDirectory(folder.resolve("bundles"))) {
      folder = folder.getParent();
    }
    return Optional.ofNullable(folder);
  }
}
