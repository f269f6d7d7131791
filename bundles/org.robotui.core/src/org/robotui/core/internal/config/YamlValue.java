package org.robotui.core.internal.config;

import java.util.List;
import java.util.Optional;
import org.robotui.api.config.Printable;

/** What stands in a YAML file, with the place where it stands. */
sealed interface YamlValue {
  /** Where it begins. */
  Place place();

  /** What it is, for messages: "a text", "a list". */
  String noun();

  /**
   * A single value.
   *
   * @param text as written, environment variables replaced
   * @param plain true where it was written without quotes, so that {@code true} and {@code 3} are no texts
   * @param place where
   */
  record Scalar(String text, boolean plain, Place place) implements YamlValue {
    private static final int SHOWN = 60;

    boolean isEmpty() {
      return plain && (text.isEmpty() || "~".equals(text) || "null".equals(text));
    }

    @Override
    public String noun() {
      return isEmpty() ? "nothing" : "'" + Printable.beginning(text, SHOWN) + "'";
    }
  }

  /**
   * A list.
   *
   * @param items its elements
   * @param place where
   */
  record Items(List<YamlValue> items, Place place) implements YamlValue {
    @Override
    public String noun() {
      return "a list";
    }
  }

  /**
   * A section: keys with values, in the order of the file.
   *
   * @param entries its entries
   * @param place where
   */
  record Section(List<Entry> entries, Place place) implements YamlValue {
    @Override
    public String noun() {
      return "a section";
    }

    Optional<Entry> entry(String key) {
      return entries.stream().filter(e -> e.key().equals(key)).findFirst();
    }

    Optional<YamlValue> get(String key) {
      return entry(key).map(Entry::value);
    }

    /** The section without some keys: what remains after the reader has taken its own. */
    Section without(List<String> keys) {
      return new Section(entries.stream().filter(e -> !keys.contains(e.key())).toList(), place);
    }
  }

  /**
   * One line of a section.
   *
   * @param key the name
   * @param place where the key stands
   * @param value what it holds
   */
  record Entry(String key, Place place, YamlValue value) {}
}
