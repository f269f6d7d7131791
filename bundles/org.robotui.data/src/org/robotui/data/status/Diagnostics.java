package org.robotui.data.status;

import java.util.List;
import java.util.Map;
import org.robotui.data.Conflation;
import org.robotui.data.Delivery;
import org.robotui.data.Keyed;
import org.robotui.data.Late;
import org.robotui.data.internal.Merge;

/**
 * What the parts of a robot say of themselves, the newest per name.
 *
 * @param items one entry a part
 */
@Delivery(conflation = Conflation.KEYED, late = Late.ALL_KEYS)
public record Diagnostics(List<Item> items) implements Keyed<Diagnostics> {
  /** The state of a part. */
  public enum Level {
    /** As it should be. */
    OK,
    /** Worth a look. */
    WARNING,
    /** Does not work. */
    ERROR,
    /** Has not reported for too long. */
    STALE
  }

  /**
   * One part.
   *
   * @param name of the part, slashes make a tree
   * @param hardware an identification of the device, may be empty
   * @param level its state
   * @param message a sentence
   * @param values details by name, in the order given
   */
  public record Item(String name, String hardware, Level level, String message, Map<String, String> values) {
    /**
     * Copies the details, their order kept.
     *
     * @param name the name
     * @param hardware the device
     * @param level the state
     * @param message a sentence
     * @param values details
     */
    public Item {
      values = java.util.Collections.unmodifiableMap(new java.util.LinkedHashMap<>(values));
    }
  }

  /**
   * Copies the list.
   *
   * @param items one entry a part
   */
  public Diagnostics {
    items = List.copyOf(items);
  }

  @Override
  public Diagnostics over(Diagnostics older) {
    return new Diagnostics(Merge.byKey(older.items, items, Item::name));
  }

  @Override
  public int keys() {
    return items.size();
  }

  @Override
  public Diagnostics last(int most) {
    return new Diagnostics(Merge.last(items, most));
  }
}
