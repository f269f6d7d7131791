package org.robotui.lcm.type;

import java.io.IOException;
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

  private final List<TypeDefinition> definitions = new ArrayList<>();
  private final List<TypeException> problems = new ArrayList<>();

  private TypeFolder() {
  }

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
    try (Stream<Path> files = Files.walk(place)) {
      for (Path file : files.filter(each -> each.equals(place) || each.toString().endsWith(ENDING)).filter(Files::isRegularFile).sorted().toList()) {
        file(file);
      }
    }
  }

  private void file(Path file) throws IOException {
    try {
      if (Files.size(file) > MOST_BYTES) {
        throw new TypeException(new Place(file.toString(), 1, 1), "a file of " + Files.size(file) + " bytes is too long", "split it");
      }
      definitions.addAll(TypeParser.parse(file.toString(), Files.readString(file, StandardCharsets.UTF_8)));
    } catch (MalformedInputException e) {
      problems.add(new TypeException(new Place(file.toString(), 1, 1), "this is no UTF-8 text", "save it as UTF-8"));
    } catch (TypeException e) {
      problems.add(e);
    }
  }
}
