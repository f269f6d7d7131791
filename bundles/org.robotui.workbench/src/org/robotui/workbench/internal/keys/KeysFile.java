package org.robotui.workbench.internal.keys;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.NamedFile;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;
import org.yaml.snakeyaml.error.YAMLException;

/**
 * The file in which the keys stand that a user has changed: YAML, a line for each command, so that it can be read,
 * written by hand and shared. Comments and the order of the lines stay when it is written.
 */
public final class KeysFile {
  private static final int VERSION = 1;
  private static final long MOST_BYTES = 1 << 18;
  private static final int MOST_KEYS = 10;
  private static final Pattern ENTRY = Pattern.compile("  '?([^'\\s#]+)'?: .*");
  private static final Pattern COMMENT = Pattern.compile("\\s+#.*");
  private static final String HEAD = """
      # Keys of RobotUI that differ from the usual ones; commands that are not here have theirs. [] is no key.
      # Window > Preferences > Keys lists all commands and writes this file; comments stay.
      version: %d
      keys:
      """.formatted(VERSION);

  private final Path file;

  /** What stands in a file, which may not be there. */
  public KeysFile(Path file) {
    this.file = file;
  }

  /** Where it is. */
  public Path path() {
    return file;
  }

  /**
   * Reads the keys by the ids of commands. What cannot be understood is left out.
   *
   * @param damage is given a few words on each thing that was left out
   */
  public Map<String, List<KeySequence>> read(Consumer<String> damage) {
    try {
      return Files.exists(file) ? read(NamedFile.text(file, MOST_BYTES), damage) : Map.of();
    } catch (IOException e) {
      damage.accept("it " + e.getMessage());
      return Map.of();
    }
  }

  private static Map<String, List<KeySequence>> read(String text, Consumer<String> damage) {
    Map<String, List<KeySequence>> read = new LinkedHashMap<>();
    try {
      if (!(new Yaml(new SafeConstructor(new LoaderOptions())).load(text) instanceof Map<?, ?> root)) {
        damage.accept("it has no 'keys:'");
      } else if (!(root.get("version") instanceof Integer version) || version != VERSION) {
        damage.accept("'version: " + root.get("version") + "' is not known, only " + VERSION);
      } else if (root.get("keys") instanceof Map<?, ?> keys) {
        keys.forEach((id, value) -> keys(String.valueOf(id), value, damage)
            .ifPresent(own -> read.put(String.valueOf(id), own)));
      } else if (root.get("keys") != null) {
        damage.accept("'keys:' is no section");
      }
    } catch (YAMLException e) {
      damage.accept("it is no YAML: " + e.getMessage().lines().findFirst().orElse(""));
    }
    return read;
  }

  /** None where nothing that was written can be understood: the usual keys then hold. */
  private static Optional<List<KeySequence>> keys(String id, Object value, Consumer<String> damage) {
    List<?> words = value instanceof List<?> list ? list : value == null ? List.of() : List.of(value);
    List<KeySequence> keys = new ArrayList<>();
    for (Object word : words.subList(0, Math.min(words.size(), MOST_KEYS))) {
      KeyWords.read(String.valueOf(word)).ifPresentOrElse(k -> judge(id, k, keys, damage),
          () -> damage.accept("'" + id + "' has '" + word + "', which is no key such as Ctrl+Shift+P"));
    }
    return keys.isEmpty() && !words.isEmpty() ? Optional.empty() : Optional.of(List.copyOf(keys));
  }

  private static void judge(String id, KeySequence key, List<KeySequence> keys, Consumer<String> damage) {
    KeyRules.refusal(key).ifPresentOrElse(why -> damage.accept("'" + id + "': " + why), () -> keys.add(key));
  }

  /**
   * Writes the keys by the ids of commands. Blocks for a small file.
   *
   * @throws IOException where it cannot be written; it stays as it was
   */
  public void write(Map<String, List<KeySequence>> keys) throws IOException {
    String next = mended(before(), keys);
    List<String> damage = new ArrayList<>();
    boolean faithful = read(next, damage::add).equals(keys) && damage.isEmpty();
    AtomicFile.writePrivate(file, faithful ? next : mended(HEAD, keys));
  }

  private String before() {
    try {
      return Files.exists(file) ? NamedFile.text(file, MOST_BYTES) : HEAD;
    } catch (IOException e) {
      return HEAD; // it was told when it was read, and is set aside
    }
  }

  /** The text with the lines of its entries changed, those that are no more left out, and new ones at its end. */
  private static String mended(String text, Map<String, List<KeySequence>> keys) {
    Map<String, List<KeySequence>> left = new LinkedHashMap<>(keys);
    List<String> lines = new ArrayList<>();
    text.lines().forEach(line -> {
      Matcher entry = ENTRY.matcher(line);
      if (!entry.matches()) {
        lines.add(line);
      } else if (left.containsKey(entry.group(1))) {
        lines.add(line(entry.group(1), left.remove(entry.group(1))) + comment(line));
      }
    });
    left.forEach((id, own) -> lines.add(line(id, own)));
    return lines.stream().collect(Collectors.joining("\n", "", "\n"));
  }

  private static String line(String id, List<KeySequence> keys) {
    return "  '" + id + "': [" + keys.stream().map(KeyWords::text).map(text -> "'" + text + "'")
        .collect(Collectors.joining(", ")) + "]";
  }

  private static String comment(String line) {
    Matcher comment = COMMENT.matcher(line);
    return comment.find() ? comment.group() : "";
  }
}
