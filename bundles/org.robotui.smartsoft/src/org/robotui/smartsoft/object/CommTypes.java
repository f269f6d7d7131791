package org.robotui.smartsoft.object;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.robotui.message.DefinitionException;
import org.robotui.message.IdlDefinitions;

/** The types of communication objects that are known. Safe for all threads. */
public final class CommTypes {

  private static final List<String> SHIPPED =
      List.of("CommBasicObjects", "CommLocalizationObjects", "CommNavigationObjects", "CommParameter", "SmartACE");
  private static final String SUFFIX = ".idl";
  private static final int MOST_FILES = 256;
  private static final long LONGEST_FILE = 1 << 20;

  private final Map<String, String> texts;
  private final IdlDefinitions definitions;
  private final Map<String, CommType> known = new ConcurrentHashMap<>();

  private CommTypes(Map<String, String> texts) {
    this.texts = texts;
    this.definitions = new IdlDefinitions(texts);
  }

  /**
   * The types that are part of this library.
   *
   * @return those of common repositories
   */
  public static CommTypes shipped() {
    Map<String, String> texts = new HashMap<>();
    for (String module : SHIPPED) {
      try (InputStream in = CommTypes.class.getResourceAsStream(module + SUFFIX)) {
        texts.put(module, new String(in.readAllBytes(), StandardCharsets.UTF_8));
      } catch (IOException e) {
        throw new UncheckedIOException("the description of " + module + " cannot be read", e);
      }
    }
    return new CommTypes(texts);
  }

  /**
   * These types and those of a folder, which win.
   *
   * @param folder with files that are called after their modules, such as {@code DomainPTU.idl}
   * @return with both
   * @throws IOException where the folder or a file in it cannot be read
   */
  public CommTypes with(Path folder) throws IOException {
    Map<String, String> more = new HashMap<>(texts);
    List<Path> files;
    try (Stream<Path> all = Files.list(folder)) {
      files = all.filter(file -> file.toString().endsWith(SUFFIX)).sorted().limit(MOST_FILES).toList();
    }
    for (Path file : files) {
      if (Files.size(file) > LONGEST_FILE) {
        throw new IOException(file + " is longer than the descriptions of any repository");
      }
      String name = file.getFileName().toString();
      more.put(name.substring(0, name.length() - SUFFIX.length()), Files.readString(file));
    }
    return new CommTypes(more);
  }

  /**
   * A type.
   *
   * @param name as SmartSoft writes it, such as {@code CommBasicObjects::CommPose3d}
   * @return empty where its repository is not known
   * @throws DefinitionException where the description of its repository is broken, or does not have it
   */
  public Optional<CommType> find(String name) throws DefinitionException {
    CommType found = known.get(name);
    int colons = name.indexOf("::");
    if (found != null || colons < 0 || !texts.containsKey(name.substring(0, colons))) {
      return Optional.ofNullable(found);
    }
    CommType read = new CommType(name, definitions.schema(name.replace("::", "/")));
    known.put(name, read);
    return Optional.of(read);
  }

  /**
   * A type that is part of this library.
   *
   * @param name as SmartSoft writes it
   * @return the type
   * @throws IllegalArgumentException where there is none of this name
   */
  public CommType get(String name) {
    try {
      return find(name).orElseThrow(() -> new IllegalArgumentException("no description of " + name + " is known"));
    } catch (DefinitionException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }
}
