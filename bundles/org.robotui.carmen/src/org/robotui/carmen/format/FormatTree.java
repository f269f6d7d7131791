package org.robotui.carmen.format;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Formats as a central sends them. The order of bytes is that of the buffer. */
public final class FormatTree {

  private static final int DEEPEST = 32;
  private static final int MOST_MEMBERS = 4096;
  private static final byte PRESENT = 'Z';
  private static final int WORD = Integer.BYTES;
  private static final int NOTHING = -1;
  private static final int SINGLE = 0;
  private static final int OPAQUE = 1;
  private static final int STRUCT = 2;
  private static final int POINTER = 3;
  private static final int FIXED = 4;
  private static final int VARIABLE = 5;
  private static final int NAMED = 7;

  private FormatTree() {}

  /**
   * Reads a format.
   *
   * @param in from its beginning; behind it afterwards
   * @return what it says
   * @throws IpcFormatException where it is none, or of a kind that was never met
   */
  public static IpcFormat read(ByteBuffer in) throws IpcFormatException {
    try {
      return read(in, 0);
    } catch (BufferUnderflowException e) {
      throw new IpcFormatException("a format ends too early");
    }
  }

  private static IpcFormat read(ByteBuffer in, int depth) throws IpcFormatException {
    if (depth > DEEPEST) {
      throw new IpcFormatException("a format has more than " + DEEPEST + " levels");
    }
    int kind = in.getInt();
    return switch (kind) {
      case NOTHING -> new IpcFormat.Nothing();
      case SINGLE -> single(in.getInt());
      case OPAQUE -> new IpcFormat.Opaque(bounded(in.getInt(), Integer.MAX_VALUE));
      case STRUCT -> struct(in, depth);
      case POINTER -> new IpcFormat.Pointer(in.get() == 0 ? new IpcFormat.Nothing() : read(in, depth + 1));
      case FIXED, VARIABLE -> array(in, depth, kind == FIXED);
      case NAMED -> new IpcFormat.Named(text(in));
      default -> throw new IpcFormatException("a format has a part of the kind " + kind + ", which is not known");
    };
  }

  private static IpcFormat single(int code) throws IpcFormatException {
    return new IpcFormat.Single(IpcPrimitive.coded(code)
        .orElseThrow(() -> new IpcFormatException("a format has a type of the number " + code
            + ", which is not known")));
  }

  private static IpcFormat struct(ByteBuffer in, int depth) throws IpcFormatException {
    int count = bounded(in.getInt() - 1, MOST_MEMBERS);
    List<IpcFormat> members = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      members.add(read(in, depth + 1));
    }
    return new IpcFormat.Struct(members);
  }

  private static IpcFormat array(ByteBuffer in, int depth, boolean fixed) throws IpcFormatException {
    int count = bounded(in.getInt() - 2, MOST_MEMBERS);
    IpcFormat element = read(in, depth + 1);
    List<Integer> numbers = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      numbers.add(bounded(in.getInt(), Integer.MAX_VALUE));
    }
    if (numbers.isEmpty()) {
      throw new IpcFormatException("a format has an array without a size");
    }
    return fixed ? new IpcFormat.FixedArray(element, numbers) : new IpcFormat.VariableArray(element, numbers);
  }

  private static String text(ByteBuffer in) throws IpcFormatException {
    byte[] characters = new byte[bounded(in.getInt(), in.remaining())];
    in.get(characters);
    if (characters.length == 0) {
      in.get();
    }
    return new String(characters, StandardCharsets.ISO_8859_1);
  }

  private static int bounded(int number, int most) throws IpcFormatException {
    if (number < 0 || number > most) {
      throw new IpcFormatException("a format has the number " + number + ", which is none of its kind");
    }
    return number;
  }

  /**
   * Writes a format.
   *
   * @param format what to write
   * @param order of bytes
   * @return its bytes
   */
  public static byte[] bytes(IpcFormat format, ByteOrder order) {
    ByteBuffer out = ByteBuffer.allocate(size(format)).order(order);
    write(format, out);
    return out.array();
  }

  private static int size(IpcFormat format) {
    return switch (format) {
      case IpcFormat.Nothing n -> WORD;
      case IpcFormat.Single s -> 2 * WORD;
      case IpcFormat.Opaque o -> 2 * WORD;
      case IpcFormat.Struct s -> 2 * WORD + s.members().stream().mapToInt(FormatTree::size).sum();
      case IpcFormat.Pointer p when p.target() instanceof IpcFormat.Nothing -> WORD + 1;
      case IpcFormat.Pointer p -> WORD + 1 + size(p.target());
      case IpcFormat.FixedArray a -> (2 + a.sizes().size()) * WORD + size(a.element());
      case IpcFormat.VariableArray a -> (2 + a.members().size()) * WORD + size(a.element());
      case IpcFormat.Named n -> 2 * WORD + Math.max(1, n.name().length());
    };
  }

  private static void write(IpcFormat format, ByteBuffer out) {
    switch (format) {
      case IpcFormat.Nothing n -> out.putInt(NOTHING);
      case IpcFormat.Single s -> out.putInt(SINGLE).putInt(s.type().code());
      case IpcFormat.Opaque o -> out.putInt(OPAQUE).putInt(o.bytes());
      case IpcFormat.Struct s -> {
        out.putInt(STRUCT).putInt(s.members().size() + 1);
        s.members().forEach(member -> write(member, out));
      }
      case IpcFormat.Pointer p -> {
        out.putInt(POINTER).put(p.target() instanceof IpcFormat.Nothing ? 0 : PRESENT);
        if (!(p.target() instanceof IpcFormat.Nothing)) {
          write(p.target(), out);
        }
      }
      case IpcFormat.FixedArray a -> array(FIXED, a.element(), a.sizes(), out);
      case IpcFormat.VariableArray a -> array(VARIABLE, a.element(), a.members(), out);
      case IpcFormat.Named n -> {
        byte[] name = n.name().getBytes(StandardCharsets.ISO_8859_1);
        out.putInt(NAMED).putInt(name.length).put(name);
        if (name.length == 0) {
          out.put(PRESENT);
        }
      }
    }
  }

  private static void array(int kind, IpcFormat element, List<Integer> numbers, ByteBuffer out) {
    out.putInt(kind).putInt(numbers.size() + 2);
    write(element, out);
    numbers.forEach(out::putInt);
  }
}
