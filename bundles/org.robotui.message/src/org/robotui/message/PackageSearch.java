package org.robotui.message;

import java.io.IOException;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.EnumSet;
import java.util.Optional;

/** Looks for a file of a package in a tree of folders, as ROS crawls its package path: packages hold no packages. */
final class PackageSearch extends SimpleFileVisitor<Path> {

  private static final int DEPTH = 4;

  private final String packageName;
  private final Path inside;
  private Path found;

  private PackageSearch(String packageName, Path inside) {
    this.packageName = packageName;
    this.inside = inside;
  }

  /** The file at the given place inside the package, which is the tree, its child, or up to four levels down. */
  static Optional<Path> find(Path tree, String packageName, Path inside) {
    Path child = tree.resolve(packageName).resolve(inside);
    return Files.isRegularFile(child) ? Optional.of(child) : new PackageSearch(packageName, inside).crawl(tree);
  }

  private Optional<Path> crawl(Path tree) {
    try {
      Files.walkFileTree(tree, EnumSet.of(FileVisitOption.FOLLOW_LINKS), DEPTH, this);
    } catch (IOException e) {
      // a folder that cannot be read holds nothing for us
      return Optional.empty();
    }
    return Optional.ofNullable(found);
  }

  @Override
  public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
    if (folder.endsWith(packageName) && Files.isRegularFile(folder.resolve(inside))) {
      found = folder.resolve(inside);
      return FileVisitResult.TERMINATE;
    }
    boolean isLeaf = folder.getFileName() != null && folder.getFileName().toString().startsWith(".")
        || Files.exists(folder.resolve("package.xml")) || Files.exists(folder.resolve("CATKIN_IGNORE"));
    return isLeaf ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
  }

  @Override
  public FileVisitResult visitFileFailed(Path file, IOException e) {
    return FileVisitResult.CONTINUE;
  }
}
