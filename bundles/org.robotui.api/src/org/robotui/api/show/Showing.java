package org.robotui.api.show;

import java.util.List;
import java.util.Objects;
import org.robotui.data.Data;
import org.robotui.data.DataType;

/**
 * One way in which the views of a type show something that a user points at elsewhere: what stands in the menus of
 * ports, frames and nodes.
 *
 * @param id unique within the type of view, given back to the view with what it shall show
 * @param label what the user reads in a menu, a short imperative such as {@code Echo} or {@code Show in Map}
 * @param kind what it is for
 * @param types the data of the streams that it takes, each with what extends it; of frames and nodes none
 */
public record Showing(String id, String label, Kind kind, List<Class<? extends Data>> types) {
  /** What is shown. */
  public enum Kind {
    /** Streams as a whole. */
    STREAM,
    /** Numbers among the fields of streams; without any named, the view lets the user choose. */
    NUMBERS,
    /** Frames. */
    FRAME,
    /** Programs. */
    NODE
  }

  /**
   * Copies the list.
   *
   * @param id unique within the type of view
   * @param label what the user reads
   * @param kind what it is for
   * @param types the data of the streams that it takes
   */
  public Showing {
    Objects.requireNonNull(id, "id");
    Objects.requireNonNull(label, "label");
    Objects.requireNonNull(kind, "kind");
    types = List.copyOf(types);
  }

  /**
   * Shows streams of some types.
   *
   * @param id unique within the type of view
   * @param label what the user reads
   * @param types of data
   * @return the showing
   */
  public static Showing streams(String id, String label, List<Class<? extends Data>> types) {
    return new Showing(id, label, Kind.STREAM, types);
  }

  /**
   * Shows numbers of any stream.
   *
   * @param id unique within the type of view
   * @param label what the user reads
   * @return the showing
   */
  public static Showing numbers(String id, String label) {
    return new Showing(id, label, Kind.NUMBERS, List.of(Data.class));
  }

  /**
   * Shows frames.
   *
   * @param id unique within the type of view
   * @param label what the user reads
   * @return the showing
   */
  public static Showing frames(String id, String label) {
    return new Showing(id, label, Kind.FRAME, List.of());
  }

  /**
   * Shows programs.
   *
   * @param id unique within the type of view
   * @param label what the user reads
   * @return the showing
   */
  public static Showing nodes(String id, String label) {
    return new Showing(id, label, Kind.NODE, List.of());
  }

  /**
   * Whether it is for subjects of a kind.
   *
   * @param subject what the user points at
   * @return false where it must not be offered at all
   */
  public boolean isFor(Subject subject) {
    return switch (subject) {
      case Subject.Stream s -> kind == Kind.STREAM || kind == Kind.NUMBERS;
      case Subject.Frame f -> kind == Kind.FRAME;
      case Subject.Node n -> kind == Kind.NODE;
    };
  }

  /**
   * Whether it takes streams of a type.
   *
   * @param produced the type of the stream
   * @return true where it is one of its types, or extends one
   */
  public boolean takes(DataType produced) {
    return types.stream().anyMatch(type -> DataType.of(type).accepts(produced));
  }
}
