package org.robotui.architecture.tests;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What CMake, shell and Python name in this repository is there. The compiler of Java sees what was moved, they do not:
 * what they name is missed only where it is used, such as in a build from nothing.
 */
final class PathRule implements Rule {

  private static final List<String> FOLDERS = List.of("rt-native", "tests", "tools", ".ci");

  private static final Pattern READ = Pattern.compile("CMakeLists\\.txt|.*\\.(cmake|sh|py)|robotui|run");

  /** From one of the folders of the root on, up to what only a run knows: a variable, a wildcard. */
  private static final Pattern PATH = Pattern.compile(
      "(?<![\\w.@$-])(?:bundles|features|product|releng|rt-native|tests|tools|docs|configs)(?:/[\\w.@%+-]+)+(?<open>/?[{$*<])?");

  private static final Pattern MADE_BY_BUILDS = Pattern.compile("/(target|build)(/|$)|^bundles/[^/]+/lib(/|$)");

  @Override
  public String statement() {
    return "paths that CMake, shell and Python name are there";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return Stream.concat(Stream.of(repository.root().resolve("robotui")).filter(Files::exists),
        FOLDERS.stream().flatMap(folder -> Trees.files(repository.root().resolve(folder), "").stream()))
        .filter(file -> Files.isRegularFile(file) && READ.matcher(file.getFileName().toString()).matches())
        .flatMap(file -> violationsIn(repository.root(), file));
  }

  private static Stream<Violation> violationsIn(Path root, Path file) {
    return PATH.matcher(Trees.read(file)).results().map(PathRule::named).flatMap(Optional::stream)
        .filter(path -> !MADE_BY_BUILDS.matcher(path).find() && !isThere(root, file, path))
        .map(path -> new Violation(root.relativize(file).toString(), "names " + path + ", which is not there"));
  }

  /** The part of it that stands in the text, without the end of a sentence. */
  private static Optional<String> named(MatchResult found) {
    String path = found.group().replaceAll("[.]$", "");
    if (found.group("open") == null) {
      return Optional.of(path);
    }
    return Optional.of(path.substring(0, path.lastIndexOf('/'))).filter(whole -> whole.indexOf('/') > 0);
  }

  /** Seen from the folder of the file, one above it, or the real-time side, whose folder has variables for its name. */
  private static boolean isThere(Path root, Path file, String path) {
    Stream<Path> above = Stream.iterate(file.getParent(), folder -> folder.startsWith(root), Path::getParent);
    return Stream.concat(above, Stream.of(root.resolve("rt-native"))).map(folder -> folder.resolve(path))
        .anyMatch(PathRule::beginsSomething);
  }

  /** A name may be the beginning of one: of a decision by its number, or up to a space. */
  private static boolean beginsSomething(Path path) {
    if (Files.exists(path) || !Files.isDirectory(path.getParent())) {
      return Files.exists(path);
    }
    try (Stream<Path> beside = Files.list(path.getParent())) {
      return beside.anyMatch(other -> other.getFileName().toString().startsWith(path.getFileName().toString()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
