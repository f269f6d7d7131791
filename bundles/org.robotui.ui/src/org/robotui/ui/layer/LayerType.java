package org.robotui.ui.layer;

import java.util.List;
import java.util.Set;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;

/**
 * A kind of layer that maps offer; one singleton OSGi service each. Methods are called from any thread and must not
 * block.
 */
public interface LayerType {
  /** On what a layer can lie. */
  enum Ground {
    /** The fixed frame of a map: data that name coordinate frames. */
    FRAME,
    /** A plane that touches the earth: data that name latitude and longitude. */
    EARTH
  }

  /**
   * What a configuration writes behind {@code type:}.
   *
   * @return a word in lower case, for example {@code scan}
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
   * The types of data that a layer needs one source of at least; it may have any number of the others.
   *
   * @return some of {@link #accepts()}
   */
  default Set<Class<? extends Data>> needs() {
    return Set.copyOf(accepts());
  }

  /**
   * Whether a view that nobody configured shows one for each source of the first type that it accepts; of a kind that
   * needs no data, one.
   *
   * @return true unless it needs no data
   */
  default boolean automatic() {
    return !needs().isEmpty();
  }

  /**
   * On what it can lie: the map lists layers that lie in frames, the GPS view those that lie on the earth.
   *
   * @return one ground at least
   */
  default Set<Ground> grounds() {
    return Set.of(Ground.FRAME);
  }

  /**
   * What it is made of, as views say when something is wrong with it.
   *
   * @return for example {@code scan}
   */
  default String data() {
    return id();
  }

  /**
   * Whether its data comes only now and then, so that a source that has sent nothing yet is no trouble.
   *
   * @return true for example for what is planned
   */
  default boolean occasional() {
    return false;
  }

  /**
   * Where it begins in the stack, before the user orders it: that of a metric grid is 0, of a floor plan 100, of what
   * sensors measure 300, of plans 500, of robots 700, of what lies on them 800.
   *
   * @return larger is above
   */
  int level();

  /**
   * The settings of one layer.
   *
   * @return the schema, without {@code type}, {@code name}, {@code source} and {@code shown}, which the view adds; a
   * setting {@link Inks#COLOR} is the colour that the view hands in as {@link LayerEntry#ink()}
   */
  Schema schema();

  /**
   * Streams beside the sources of a layer that its settings name; what they give comes with the same ticks.
   *
   * @param settings of a layer, checked
   * @return their sources, of whatever type
   */
  default Set<SourceId> also(Settings settings) {
    return Set.of();
  }

  /**
   * Makes a layer.
   *
   * @param context of the view it is made for
   * @return a layer without data
   */
  DataLayer create(LayerContext context);
}
