package org.robotui.api.config;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/** What a setting may hold. */
public sealed interface ValueType {
  /**
   * Takes a value that was not written in a file, such as one that a user chose.
   *
   * @param value a Boolean, Number, String, List or Map
   * @return the value as {@link Settings} hold it; empty where it does not fit
   */
  default Optional<Object> fit(Object value) {
    return ValueCheck.fit(this, value);
  }

  /**
   * What a value must be.
   *
   * @return words that stand behind "must be"
   */
  default String expected() {
    return ValueCheck.expected(this);
  }

  /**
   * A text.
   *
   * @param rule what it must be like
   */
  record Text(TextRule rule) implements ValueType {
    /** Any text. */
    public Text() {
      this(TextRule.ANY);
    }

    /**
     * Judges a text.
     *
     * @param text the text
     * @return why it does not fit; an empty reason where there is nothing to add, nothing where it fits
     */
    public Optional<String> fault(String text) {
      return text.length() > TextRule.LONGEST
          ? Optional.of("it has " + text.length() + " characters; at most " + TextRule.LONGEST + " are read")
          : rule.fault().apply(text);
    }
  }

  /** True or false. */
  record Flag() implements ValueType {}

  /**
   * A finite number within limits, which are finite as well: what has no bound by its nature gets one beyond everything
   * that makes sense.
   *
   * @param min the smallest allowed
   * @param max the largest allowed
   * @param unit for display, for example {@code m/s}; empty for a plain number, such as a share, whose help says what
   * it counts
   */
  record Num(double min, double max, String unit) implements ValueType {
    /**
     * Checks the limits.
     *
     * @param min the smallest allowed
     * @param max the largest allowed
     * @param unit for display
     */
    public Num {
      if (!Double.isFinite(min) || !Double.isFinite(max) || min > max) {
        throw new IllegalArgumentException("no range of numbers: " + min + " to " + max);
      }
    }
  }

  /**
   * A whole number within limits.
   *
   * @param min the smallest allowed
   * @param max the largest allowed
   */
  record Int(long min, long max) implements ValueType {}

  /**
   * One of some words.
   *
   * @param words the words
   */
  record Choice(List<String> words) implements ValueType {}

  /**
   * A list.
   *
   * @param element what its elements hold
   */
  record ListOf(ValueType element) implements ValueType {}

  /**
   * Values by freely chosen names.
   *
   * @param value what each holds
   */
  record MapOf(ValueType value) implements ValueType {}

  /**
   * A group of settings.
   *
   * @param schema what it may hold
   */
  record Section(Schema schema) implements ValueType {}

  /**
   * One of several shapes, tried in order, for short forms.
   *
   * @param alternatives the shapes
   */
  record AnyOf(List<ValueType> alternatives) implements ValueType {}

  /**
   * What follows from another setting of the same group, such as the settings of a kind. Who does not see that setting
   * takes what is otherwise allowed.
   *
   * @param setting the name of the other setting
   * @param types what is allowed by the words of that setting
   * @param otherwise what is allowed for other words, and where nothing is written
   */
  record Dependent(String setting, Map<String, ValueType> types, ValueType otherwise) implements ValueType {
    /**
     * Copies the map.
     *
     * @param setting the name of the other setting
     * @param types by word
     * @param otherwise for other words
     */
    public Dependent {
      types = Map.copyOf(types);
    }

    /**
     * What is allowed in a group.
     *
     * @param group values by the names of settings, the other one among them
     * @return a type
     */
    public ValueType in(Map<?, ?> group) {
      return Optional.ofNullable(group.get(setting)).flatMap(word -> Optional.ofNullable(types.get(word.toString())))
          .orElse(otherwise);
    }
  }

  /**
   * A value that is held as a {@link Placed}: together with where it is written.
   *
   * @param value what may be written
   */
  record WithPlace(ValueType value) implements ValueType {}
}
