package org.robotui.core.internal.facts;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The files of a folder that tell something. What cannot be looked at is left out. */
final class KeptFiles {
  private static final int MOST_LISTED = 5000;
  private static final int DEPTH = 6;

  private final Path folder;
  private final Map<Path, BasicFileAttributes> files = new TreeMap<>();

  /** Looks; the folder need not exist. */
  KeptFiles(Path folder) throws IOException {
    this.folder = folder;
    if (Files.isDirectory(folder)) {
      Files.walkFileTree(folder, EnumSet.noneOf(FileVisitOption.class), DEPTH, new Look());
    }
  }

  /** Those that fit one of some patterns, the newest first. */
  List<Path> matching(int most, String... patterns) {
    List<PathMatcher> matchers =
        Stream.of(patterns).map(pattern -> FileSystems.getDefault().getPathMatcher("glob:" + pattern)).toList();
    return files.entrySet().stream()
        .filter(file -> matchers.stream().anyMatch(m -> m.matches(folder.relativize(file.getKey()))))
        .sorted(Comparator.comparing(file -> file.getValue().lastModifiedTime(), Comparator.reverseOrder()))
        .limit(most).map(Map.Entry::getKey).toList();
  }

  /** Size, time and name of every file. */
  String list() {
    return files.entrySet().stream().map(file -> String.format(Locale.ROOT, "%10d  %s  %s", file.getValue().size(),
        file.getValue().lastModifiedTime(), folder.relativize(file.getKey()))).collect(Collectors.joining("\n"));
  }

  private final class Look extends SimpleFileVisitor<Path> {
    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes what) {
      if (what.isRegularFile()) {
        files.put(file, what);
      }
      return files.size() < MOST_LISTED ? FileVisitResult.CONTINUE : FileVisitResult.TERMINATE;
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException e) {
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult postVisitDirectory(Path left, IOException e) {
      return FileVisitResult.CONTINUE;
    }
  }
}
