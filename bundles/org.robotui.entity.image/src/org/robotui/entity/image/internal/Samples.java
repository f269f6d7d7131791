package org.robotui.entity.image.internal;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;

/** The numbers of a raw picture, one by one or a row at a time. For one thread at a time. */
final class Samples {
  private final RawImage raw;
  private final PixelEncoding.Sample form;
  private final ByteBuffer bytes;
  private final ByteOrder order;
  private final byte[] row;

  Samples(RawImage raw) {
    this.raw = raw;
    this.form = raw.encoding().sample();
    this.order = raw.bigEndian() ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    this.bytes = raw.pixels().buffer(order);
    this.row = new byte[raw.width() * raw.encoding().bytesPerPixel()];
  }

  /** How many numbers a row has. */
  int perRow() {
    return raw.width() * raw.encoding().channels();
  }

  double at(int x, int y, int channel) {
    int at = y * raw.step() + x * raw.encoding().bytesPerPixel() + channel * form.bytes();
    return switch (form) {
      case U8 -> bytes.get(at) & 0xff;
      case S8 -> bytes.get(at);
      case U16 -> bytes.getShort(at) & 0xffff;
      case S16 -> bytes.getShort(at);
      case S32 -> bytes.getInt(at);
      case F32 -> bytes.getFloat(at);
      case F64 -> bytes.getDouble(at);
    };
  }

  /** Reads unsigned numbers of 8 or 16 bits. */
  void whole(int y, int[] out, int outFrom) {
    take(y);
    int count = perRow();
    if (form == PixelEncoding.Sample.U8) {
      for (int i = 0; i < count; i++) {
        out[outFrom + i] = row[i] & 0xff;
      }
    } else {
      VarHandle shorts = view(short[].class);
      for (int i = 0; i < count; i++) {
        out[outFrom + i] = (short) shorts.get(row, 2 * i) & 0xffff;
      }
    }
  }

  /** Reads numbers of any form. */
  void real(int y, float[] out) {
    take(y);
    switch (form) {
      case U8, S8 -> bytes(out);
      case U16, S16 -> shorts(out);
      case S32 -> ints(out);
      case F32 -> floats(out);
      case F64 -> doubles(out);
    }
  }

  private void take(int y) {
    raw.pixels().copyTo(y * raw.step(), row, 0, row.length);
  }

  private void bytes(float[] out) {
    int mask = form == PixelEncoding.Sample.U8 ? 0xff : -1;
    for (int i = 0; i < row.length; i++) {
      out[i] = row[i] & mask;
    }
  }

  private void shorts(float[] out) {
    VarHandle view = view(short[].class);
    int mask = form == PixelEncoding.Sample.U16 ? 0xffff : -1;
    for (int i = 0; i < row.length / Short.BYTES; i++) {
      out[i] = (short) view.get(row, i * Short.BYTES) & mask;
    }
  }

  private void ints(float[] out) {
    VarHandle view = view(int[].class);
    for (int i = 0; i < row.length / Integer.BYTES; i++) {
      out[i] = (int) view.get(row, i * Integer.BYTES);
    }
  }

  private void floats(float[] out) {
    VarHandle view = view(float[].class);
    for (int i = 0; i < row.length / Float.BYTES; i++) {
      out[i] = (float) view.get(row, i * Float.BYTES);
    }
  }

  private void doubles(float[] out) {
    VarHandle view = view(double[].class);
    for (int i = 0; i < row.length / Double.BYTES; i++) {
      out[i] = (float) (double) view.get(row, i * Double.BYTES);
    }
  }

  private VarHandle view(Class<?> array) {
    return MethodHandles.byteArrayViewVarHandle(array, order);
  }
}
