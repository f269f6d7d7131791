package org.robotui.gl.display;

import java.util.List;
import java.util.Set;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;

/**
 * A kind of display that scenes offer; one singleton OSGi service each. Methods are called from any thread and must not
 * block.
 */
public interface DisplayType {
  /**
   * What a configuration writes behind {@code type:}.
   *
   * @return a word in lower case, for example {@code laserscan}
   */
  String id();

  /**
   * The name for users.
   *
   * @return for example {@code Laser scan}
   */
  String label();

  /**
   * A sentence for users.
   *
   * @return what it shows
   */
  String help();

  /**
   * The data it can show; one that needs none (a grid) answers nothing.
   *
   * @return the types, the most important first
   */
  List<Class<? extends Data>> accepts();

  /**
   * The types of data that a display needs one source of at least; it may have any number of the others.
   *
   * @return some of {@link #accepts()}
   */
  default Set<Class<? extends Data>> needs() {
    return Set.copyOf(accepts());
  }

  /**
   * Whether a scene that nobody configured shows one for each source of the first type that it accepts; of a kind that
   * needs no data, one.
   *
   * @return true unless it needs no data; kinds that cost much (pictures) or say too much at once (all frames) answer
   * false
   */
  default boolean automatic() {
    return !needs().isEmpty();
  }

  /**
   * The settings of one display.
   *
   * @return the schema, without {@code type}, {@code name}, {@code source} and {@code shown}, which the scene adds
   */
  Schema schema();

  /**
   * Streams beside the sources of a display that its settings name; what they give comes with the same ticks.
   *
   * @param settings of a display, checked
   * @return their sources, of whatever type
   */
  default Set<SourceId> also(Settings settings) {
    return Set.of();
  }

  /**
   * Makes a display.
   *
   * @param context of the scene it is made for
   * @return a display without data
   */
  Display create(DisplayContext context);
}
