package org.robotui.urdf.pack;

import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Finds the files that models name. A root is a package, or contains packages, as with {@code ROS_PACKAGE_PATH}. What
 * lies outside, also by {@code ..} or a link, is refused; a link may lead from one root to another, as in a workspace
 * that colcon installed by links. Methods read folders and may block; safe for all threads.
 */
public final class PackageFolders {
  private static final long MOST_BYTES = 512L << 20;

  private final List<Path> roots;
  private final Map<String, Optional<Path>> found = new ConcurrentHashMap<>();

  /**
   * Takes the roots.
   *
   * @param roots the first goes before the others; those that are not there are passed over
   */
  public PackageFolders(List<Path> roots) {
    this.roots = roots.stream().map(root -> root.toAbsolutePath().normalize()).distinct().toList();
  }

  /**
   * The roots of a list as {@code ROS_PACKAGE_PATH} has them.
   *
   * @param list paths with colons between them
   * @return the absolute ones among them
   */
  public static List<Path> split(String list) {
    return List.of(list.split(":")).stream().filter(path -> path.startsWith("/")).flatMap(path -> path(path).stream())
        .toList();
  }

  /**
   * Finds a file.
   *
   * @param uri {@code package://NAME/...}, or {@code file:///...} within a root
   * @return the file, or why it is not read
   */
  public PackageFile find(String uri) {
    try {
      if (uri.startsWith("package://")) {
        return inPackage(uri, decoded(uri.substring("package://".length())));
      }
      if (uri.startsWith("file://")) {
        return inRoots(uri, decoded(uri.substring("file://".length())));
      }
      return new PackageFile.Refused("'" + shortened(uri)
          + "' is not read, must be package://PACKAGE/... or file:///... : nothing is fetched from elsewhere");
    } catch (IOException | URISyntaxException | InvalidPathException e) {
      return new PackageFile.Refused("'" + shortened(uri) + "' cannot be read: " + e.getMessage());
    }
  }

  /**
   * Finds a file that another one names, within the package of the other.
   *
   * @param file the other
   * @param name relative to it, or {@code package://NAME/...}
   * @return the file, or why it is not read
   */
  public PackageFile beside(PackageFile.Found file, String name) {
    if (name.startsWith("package://")) {
      return find(name);
    }
    try {
      String relative = name.replace('\\', '/');
      return inside(file.folder(), file.file().resolveSibling(relative), name);
    } catch (IOException | InvalidPathException e) {
      return new PackageFile.Refused("'" + shortened(name) + "' cannot be read: " + e.getMessage());
    }
  }

  private PackageFile inPackage(String uri, String rest) throws IOException {
    int slash = rest.indexOf('/');
    String name = slash < 0 ? rest : rest.substring(0, slash);
    if (name.isEmpty() || name.startsWith(".") || slash < 0) {
      return new PackageFile.Refused("'" + shortened(uri) + "' names no file, must be package://PACKAGE/folder/file");
    }
    Optional<Path> folder = found.computeIfAbsent(name, n -> new PackageSearch(roots).folder(n));
    if (folder.isEmpty()) {
      return new PackageFile.Refused(
          "the package '" + name + "' is not in " + (roots.isEmpty() ? "any folder (none is known)" : roots)
              + "; add the folder that contains it to 'packages'");
    }
    return inside(folder.get(), folder.get().resolve(rest.substring(slash + 1)), uri);
  }

  private PackageFile inRoots(String uri, String path) throws IOException {
    Path file = Path.of(path);
    Set<String> tried = new LinkedHashSet<>();
    for (Path root : roots) {
      if (file.isAbsolute() && Files.isDirectory(root) && file.normalize().startsWith(root)) {
        return inside(root, file, uri);
      }
      tried.add(root.toString());
    }
    return new PackageFile.Refused(
        "'" + shortened(uri) + "' lies outside of the folders of packages " + tried + "; add its folder to 'packages'");
  }

  /** The file, where it really lies in the folder. */
  private PackageFile inside(Path base, Path file, String uri) throws IOException {
    if (!file.normalize().startsWith(base)) {
      return new PackageFile.Refused(
          "'" + shortened(uri) + "' leads out of its package " + base + ", which is not followed");
    }
    if (!Files.exists(file)) {
      return new PackageFile.Refused("there is no file " + file);
    }
    Path folder = base.toRealPath();
    Path real = file.toRealPath();
    if (!real.startsWith(folder) && !isInARoot(real)) {
      return new PackageFile.Refused("'" + shortened(uri) + "' leads out of its package " + folder
          + " by a link, which is not followed; copy the file into the package, or add the folder " + real.getParent()
          + " to 'packages'");
    }
    if (!Files.isRegularFile(real)) {
      return new PackageFile.Refused(real + " is no file");
    }
    long size = Files.size(real);
    return size <= MOST_BYTES ? new PackageFile.Found(real, folder)
        : new PackageFile.Refused(real + " has " + size + " bytes, more than the " + MOST_BYTES + " that are read");
  }

  private boolean isInARoot(Path real) throws IOException {
    for (Path root : roots) {
      if (Files.isDirectory(root) && real.startsWith(root.toRealPath())) {
        return true;
      }
    }
    return false;
  }

  private static String decoded(String text) throws URISyntaxException {
    return text.indexOf('%') < 0 ? text
        : Optional.ofNullable(new URI("x:/" + text.replace(" ", "%20")).getPath()).orElse("/").substring(1);
  }

  private static Optional<Path> path(String text) {
    try {
      return Optional.of(Path.of(text).normalize());
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private static String shortened(String text) {
    return text.length() <= 200 ? text : text.substring(0, 200) + "...";
  }
}
