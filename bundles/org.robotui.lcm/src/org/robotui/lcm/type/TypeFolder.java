package org.robotui.lcm.type;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.MalformedInputException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Reads {@code .lcm} files and folders of them. */
public final class TypeFolder {

  private static final String ENDING = ".lcm";
  private static final long MOST_BYTES = 4L << 20;
  private static final long MOST_FILES = 20_000;

  private final List<TypeDefinition> definitions = new ArrayList<>();
  private final List<TypeException> problems = new ArrayList<>();

  private TypeFolder() {}

  /**
   * Reads all types at some places.
   *
   * @param places files, and folders whose {@code .lcm} files count at any depth
   * @return what could be read, and what is wrong with the rest
   * @throws IOException if a place cannot be read; the message names it
   */
  public static TypeLibrary read(List<Path> places) throws IOException {
    TypeFolder folder = new TypeFolder();
    for (Path place : places) {
      folder.place(place);
    }
    return TypeLibrary.of(folder.definitions, folder.problems);
  }

  private void place(Path place) throws IOException {
    if (!Files.exists(place)) {
      throw new IOException("there is no file or folder " + place);
    }
    for (Path file : files(place)) {
      file(file);
    }
  }

  /**
   * Not all that is somewhere below a folder such as / may be looked at, nor is it types: a folder of types is small.
   */
  private static List<Path> files(Path place) throws IOException {
    try (Stream<Path> all = Files.walk(place)) {
      List<Path> seen = all.limit(MOST_FILES + 1).toList();
      if (seen.size() > MOST_FILES) {
        throw new IOException(
            "there is far more than types in " + place + ": name the folder of the .lcm files itself");
      }
      return seen.stream().filter(each -> each.equals(place) || each.toString().endsWith(ENDING))
          .filter(Files::isRegularFile).sorted().toList();
    } catch (UncheckedIOException e) {
      throw new IOException(
          place + " cannot be looked through, as not all in it may be read (" + e.getCause().getMessage() + ")", e);
    }
  }

  private void file(Path file) throws IOException {
    try {
      if (Files.size(file) > MOST_BYTES) {
        throw new TypeException(new Place(file.toString(), 1, 1),
            "a file of " + Files.size(file) + " bytes is too long", "split it");
      }
      definitions.addAll(TypeParser.parse(file.toString(), Files.readString(file, StandardCharsets.UTF_8)));
    } catch (MalformedInputException e) {
      problems.add(new TypeException(new Place(file.toString(), 1, 1), "this is no UTF-8 text", "save it as UTF-8"));
    } catch (TypeException e) {
      problems.add(e);
    }
  }
}
