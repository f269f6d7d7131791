package org.robotui.ui.display;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;

/** How one of a list is written in settings. */
public final class DisplayEntry {
  /** The setting that says whether what robots offer is shown by itself. */
  public static final String AUTOMATIC = "automatic";
  /** The kind. */
  public static final String TYPE = "type";

  static final String ID = "id";
  static final String NAME = "name";
  static final String SOURCE = "source";
  static final String SHOWN = "shown";
  static final String SETTINGS = "settings";

  private static final ValueType PLAIN = new ValueType.AnyOf(List.of(new ValueType.Flag(),
      new ValueType.Int(Long.MIN_VALUE, Long.MAX_VALUE), new ValueType.Num(-Double.MAX_VALUE, Double.MAX_VALUE, ""),
      new ValueType.Text()));
  private static final ValueType ANY =
      new ValueType.WithPlace(
          new ValueType.AnyOf(List.of(PLAIN, new ValueType.ListOf(PLAIN), new ValueType.MapOf(PLAIN))));
  private static final ValueType SOURCES =
      new ValueType.AnyOf(List.of(new ValueType.Text(), new ValueType.ListOf(new ValueType.Text())));

  private DisplayEntry() {}

  /**
   * The type of a setting that lists some.
   *
   * @param noun what one is called, for example {@code display}
   * @param example of a kind, for example {@code laserscan}
   * @return a list of groups
   */
  public static ValueType list(String noun, String example) {
    return list(noun, example, List.of());
  }

  /**
   * The same with kinds to choose from; others may be written, as they may be installed later.
   *
   * @param noun what one is called, for example {@code display}
   * @param example of a kind, for example {@code laserscan}
   * @param kinds those that there are
   * @return a list of groups
   */
  public static ValueType list(String noun, String example, List<DisplayKind> kinds) {
    TextRule kind = TextRule.matching("the kind of a " + noun + ", such as " + example, "[a-z][a-z0-9_]{0,99}");
    List<String> words = kinds.stream().map(DisplayKind::id).sorted().toList();
    ValueType written = kinds.isEmpty() ? new ValueType.Text(kind)
        : new ValueType.AnyOf(List.of(new ValueType.Text(kind), new ValueType.Choice(words)));
    return new ValueType.ListOf(new ValueType.Section(Schema.of(
        Setting.required(TYPE, written, "The kind of the " + noun + ", for example " + example + "."),
        Setting.optional(ID, new ValueType.Text(),
            "Tells " + noun + "s apart where names change; written by the view."),
        Setting.optional(NAME, new ValueType.Text(), "Its name in the list; without, that of its kind."),
        Setting.of(SOURCE, SOURCES, List.of(),
            "Where its data come from, for example base/scan, or several; without, the only source that fits."),
        Setting.of(SHOWN, new ValueType.Flag(), true, "Whether it is shown."),
        Setting.of(SETTINGS, settings(kinds), Map.of(), "The settings of its kind."))));
  }

  private static ValueType settings(List<DisplayKind> kinds) {
    ValueType any = new ValueType.MapOf(ANY);
    return kinds.isEmpty() ? any
        : new ValueType.Dependent(TYPE, kinds.stream()
            .collect(Collectors.toMap(DisplayKind::id, kind -> new ValueType.Section(kind.schema()), (a, b) -> a)),
            any);
  }
}
