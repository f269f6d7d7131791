package org.robotui.api;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Files and folders that a robot interface opens without a configuration of a user.
 *
 * @param label what they are, for users, in the plural, for example {@code Recordings}
 * @param extensions what their names end with, without the dot before it, in lower case, at least one
 * @param folders by which files in it a folder is one of these, of which one is enough: their names, with {@code *} for
 * any letters; none where no folder is opened
 * @param setting the setting of the type that takes the path of such a file or folder, as a text
 */
public record FileKind(String label, List<String> extensions, List<String> folders, String setting) {
  /**
   * Copies and checks.
   *
   * @param label what they are
   * @param extensions what their names end with
   * @param folders by which files a folder is one
   * @param setting takes the path
   * @throws IllegalArgumentException where there is no extension, or one with a dot at its start or capital letters
   */
  public FileKind {
    extensions = List.copyOf(extensions);
    folders = List.copyOf(folders);
    if (extensions.isEmpty()) {
      throw new IllegalArgumentException(label + ": files need an extension");
    }
    extensions.stream().filter(e -> e.isEmpty() || e.startsWith(".") || !e.equals(e.toLowerCase(Locale.ROOT)))
        .findFirst().ifPresent(e -> {
          throw new IllegalArgumentException(label + ": '" + e + "' is no extension in lower case without a dot");
        });
  }

  /**
   * Files alone.
   *
   * @param label what they are
   * @param extensions what their names end with
   * @param setting takes the path
   */
  public FileKind(String label, List<String> extensions, String setting) {
    this(label, extensions, List.of(), setting);
  }

  /**
   * What is opened where a user names a path: the file, a folder, or the folder in which a file lies by whose whole
   * name folders are known. Folders are looked into.
   *
   * @param path a file or a folder
   * @return what is opened, or none where it is none of these
   */
  public Optional<Path> place(Path path) {
    String name = String.valueOf(path.getFileName());
    if (Files.isDirectory(path)) {
      return folders.stream().anyMatch(mark -> has(path, mark)) ? Optional.of(path) : Optional.empty();
    }
    if (folders.contains(name)) {
      return Optional.ofNullable(path.toAbsolutePath().getParent());
    }
    return extension(name).map(any -> path);
  }

  private static boolean has(Path folder, String mark) {
    try (DirectoryStream<Path> found = Files.newDirectoryStream(folder, mark)) {
      return found.iterator().hasNext();
    } catch (IOException e) {
      return false; // what cannot be looked into is opened by nobody
    }
  }

  /**
   * By which of its extensions a name is one of these; whether letters are capital does not matter.
   *
   * @param name of a file
   * @return the longest extension that fits, or none
   */
  public Optional<String> extension(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return extensions.stream().filter(e -> lower.endsWith("." + e) && lower.length() > e.length() + 1)
        .max((a, b) -> Integer.compare(a.length(), b.length()));
  }
}
