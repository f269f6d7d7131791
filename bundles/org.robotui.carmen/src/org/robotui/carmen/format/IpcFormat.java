package org.robotui.carmen.format;

import java.util.List;
import java.util.stream.Collectors;

/** What a message, or a part of one, consists of. Immutable; {@link #toString} is the language of IPC. */
public sealed interface IpcFormat {

  /**
   * How many bytes a value of it has at least, by which counts that lie are found.
   *
   * @return 0 only where nothing is sent
   */
  int leastBytes();

  /**
   * A primitive value.
   *
   * @param type which
   */
  record Single(IpcPrimitive type) implements IpcFormat {
    @Override
    public int leastBytes() {
      return type.bytes();
    }

    @Override
    public String toString() {
      return type.word();
    }
  }

  /**
   * Members, one after another.
   *
   * @param members in their order
   */
  record Struct(List<IpcFormat> members) implements IpcFormat {
    /** Copies the list. */
    public Struct {
      members = List.copyOf(members);
    }

    @Override
    public int leastBytes() {
      return (int) Math.min(Integer.MAX_VALUE, members.stream().mapToLong(IpcFormat::leastBytes).sum());
    }

    @Override
    public String toString() {
      return members.stream().map(IpcFormat::toString).collect(Collectors.joining(",", "{", "}"));
    }
  }

  /**
   * A value that may be absent.
   *
   * @param target what it is where it is there
   */
  record Pointer(IpcFormat target) implements IpcFormat {
    @Override
    public int leastBytes() {
      return 1;
    }

    @Override
    public String toString() {
      return "*" + target;
    }
  }

  /**
   * An array of a size that the format says.
   *
   * @param element of which
   * @param sizes of its dimensions, at least one
   */
  record FixedArray(IpcFormat element, List<Integer> sizes) implements IpcFormat {
    /** Copies the list. */
    public FixedArray {
      sizes = List.copyOf(sizes);
    }

    /**
     * How many elements it has.
     *
     * @return the product of the sizes, at most 2^31 - 1
     */
    public int count() {
      long count = 1;
      for (int size : sizes) {
        count = Math.min(Integer.MAX_VALUE, count * size);
      }
      return (int) count;
    }

    @Override
    public int leastBytes() {
      return (int) Math.min(Integer.MAX_VALUE, (long) count() * element.leastBytes());
    }

    @Override
    public String toString() {
      return "[" + element + ":" + joined(sizes) + "]";
    }
  }

  /**
   * An array whose sizes are members of the structure around it.
   *
   * @param element of which
   * @param members their numbers, from 1, at least one
   */
  record VariableArray(IpcFormat element, List<Integer> members) implements IpcFormat {
    /** Copies the list. */
    public VariableArray {
      members = List.copyOf(members);
    }

    @Override
    public int leastBytes() {
      return Integer.BYTES * members.size();
    }

    @Override
    public String toString() {
      return "<" + element + ":" + joined(members) + ">";
    }
  }

  /**
   * Bytes that nothing is known of but their number.
   *
   * @param bytes how many
   */
  record Opaque(int bytes) implements IpcFormat {
    @Override
    public int leastBytes() {
      return bytes;
    }

    @Override
    public String toString() {
      return Integer.toString(bytes);
    }
  }

  /**
   * A format that was given a name elsewhere. What it consists of is not known here.
   *
   * @param name which
   */
  record Named(String name) implements IpcFormat {
    @Override
    public int leastBytes() {
      return 0;
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** Nothing is sent. */
  record Nothing() implements IpcFormat {
    @Override
    public int leastBytes() {
      return 0;
    }

    @Override
    public String toString() {
      return "";
    }
  }

  private static String joined(List<Integer> numbers) {
    return numbers.stream().map(String::valueOf).collect(Collectors.joining(","));
  }
}
