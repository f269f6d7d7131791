package org.robotui.urdf.pack;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Looks for the folder of a package: near the roots first, then in what lies below, not too deep and not too many. */
final class PackageSearch {
  private static final int DEEPEST = 5;
  private static final int MOST_FOLDERS = 20_000;
  private static final int MANIFEST_BYTES = 1 << 16;
  private static final Pattern NAME = Pattern.compile("<name>\\s*([^<\\s]+)\\s*</name>");

  private final List<Path> roots;
  private int visited;

  PackageSearch(List<Path> roots) {
    this.roots = roots;
  }

  Optional<Path> folder(String name) {
    for (Path root : roots) {
      if (isNamed(root, name) || declares(root, name)) {
        return Optional.of(root);
      }
      Path below = root.resolve(name);
      if (Files.isDirectory(below)) {
        return Optional.of(below);
      }
    }
    return roots.stream().flatMap(root -> below(root, name).stream()).findFirst();
  }

  private static boolean isNamed(Path root, String name) {
    return Files.isDirectory(root)
        && Optional.ofNullable(root.getFileName()).filter(n -> n.toString().equals(name)).isPresent();
  }

  private Optional<Path> below(Path root, String name) {
    record At(Path folder, int depth) {}
    Queue<At> next = new ArrayDeque<>(List.of(new At(root, 0)));
    while (!next.isEmpty() && visited++ < MOST_FOLDERS) {
      At at = next.remove();
      if (declares(at.folder, name)) {
        return Optional.of(at.folder);
      }
      if (at.depth < DEEPEST && !Files.exists(at.folder.resolve("package.xml"))) {
        folders(at.folder).forEach(folder -> next.add(new At(folder, at.depth + 1)));
      }
    }
    return Optional.empty();
  }

  private static List<Path> folders(Path folder) {
    try (Stream<Path> all = Files.list(folder)) {
      return all.filter(p -> !p.getFileName().toString().startsWith(".") && Files.isDirectory(p)).sorted()
          .limit(MOST_FOLDERS).toList();
    } catch (IOException e) {
      // what cannot be listed contains no package that could be read
      return List.of();
    }
  }

  /** Whether its package.xml has the name. */
  private static boolean declares(Path folder, String name) {
    Path manifest = folder.resolve("package.xml");
    if (!Files.isRegularFile(manifest)) {
      return false;
    }
    try (InputStream in = Files.newInputStream(manifest)) {
      Matcher matcher = NAME.matcher(new String(in.readNBytes(MANIFEST_BYTES), StandardCharsets.UTF_8));
      return matcher.find() && matcher.group(1).equals(name);
    } catch (IOException e) {
      return false;
    }
  }
}
