package org.robotui.player.layout;

import java.lang.reflect.Array;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.XdrReader;
import org.robotui.player.wire.XdrWriter;

/**
 * The built-in types of layouts; in Java values they are {@code int}, {@code long}, {@code float}, {@code double},
 * {@code boolean}.
 */
enum Primitive {
  U8(int.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return in.within(0, 0xff);
    }
  },
  I8(int.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return in.within(Byte.MIN_VALUE, Byte.MAX_VALUE);
    }
  },
  U16(int.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return in.within(0, 0xffff);
    }
  },
  I16(int.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return in.within(Short.MIN_VALUE, Short.MAX_VALUE);
    }
  },
  I32(int.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return in.i32();
    }
  },
  U32(long.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return in.u32();
    }
  },
  I64(long.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return in.i64();
    }

    @Override
    void write(Object value, XdrWriter out) {
      out.i64(((Number) value).longValue());
    }
  },
  F32(float.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return in.f32();
    }

    @Override
    void write(Object value, XdrWriter out) {
      out.f32(((Number) value).floatValue());
    }
  },
  F64(double.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return in.f64();
    }

    @Override
    void write(Object value, XdrWriter out) {
      out.f64(((Number) value).doubleValue());
    }
  },
  BOOL(boolean.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return in.i32() != 0;
    }

    @Override
    void write(Object value, XdrWriter out) {
      out.i32((Boolean) value ? 1 : 0);
    }
  },
  /** Text with its length and a zero at its end. */
  STRING(String.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return text(in);
    }

    @Override
    void write(Object value, XdrWriter out) {
      byte[] bytes = ((String) value).getBytes(StandardCharsets.UTF_8);
      out.i32(bytes.length + 1L).i32(bytes.length + 1L).bytes(Arrays.copyOf(bytes, bytes.length + 1));
    }
  },
  /** As a string, but without any byte when it is empty. */
  LABEL(String.class) {
    @Override
    Object read(XdrReader in) throws PlayerException {
      return text(in);
    }

    @Override
    void write(Object value, XdrWriter out) {
      if (value.equals("")) {
        out.i32(0).i32(0);
      } else {
        STRING.write(value, out);
      }
    }
  };

  private final Class<?> java;

  Primitive(Class<?> java) {
    this.java = java;
  }

  /** The type by its name in a layout. */
  static Optional<Primitive> of(String name) {
    return Arrays.stream(values()).filter(each -> each.name().toLowerCase(Locale.ROOT).equals(name)).findFirst();
  }

  private static String text(XdrReader in) throws PlayerException {
    int count = in.count(1);
    in.sameCount(count);
    byte[] bytes = in.bytes(count);
    int end = 0;
    while (end < count && bytes[end] != 0) {
      end++;
    }
    return new String(bytes, 0, end, StandardCharsets.UTF_8);
  }

  abstract Object read(XdrReader in) throws PlayerException;

  void write(Object value, XdrWriter out) {
    out.i32(((Number) value).longValue());
  }

  Class<?> java() {
    return java;
  }

  /** Whether arrays of it are packed bytes. */
  boolean isByte() {
    return this == U8 || this == I8;
  }

  /** The fewest bytes one value takes on the wire. */
  int minBytes() {
    return this == I64 || this == F64 || java == String.class ? Long.BYTES : Integer.BYTES;
  }

  /** What a field has of which nobody said anything. */
  Object zero() {
    return switch (this) {
      case BOOL -> false;
      case STRING, LABEL -> "";
      case F32 -> 0f;
      case F64 -> 0d;
      case U32, I64 -> 0L;
      default -> 0;
    };
  }

  /** A plain Java value as this type keeps it. */
  Object of(Object value) {
    return switch (this) {
      case BOOL -> value instanceof Number number ? number.doubleValue() != 0 : (Boolean) value;
      case STRING, LABEL -> (String) value;
      case F32 -> ((Number) value).floatValue();
      case F64 -> ((Number) value).doubleValue();
      case U32, I64 -> ((Number) value).longValue();
      default -> ((Number) value).intValue();
    };
  }

  /** An array of zeros. */
  Object zeros(int count) {
    return Array.newInstance(isByte() ? byte.class : java, count);
  }
}
