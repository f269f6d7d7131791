package org.robotui.sim.internal;

import java.io.ByteArrayOutputStream;
import java.util.zip.Deflater;

/** Packs bytes as zlib does, which is how servers send maps. */
public final class ZlibBytes {
  private static final int CHUNK = 4096;

  private ZlibBytes() {}

  /** The packed bytes. */
  public static byte[] of(byte[] plain) {
    Deflater deflater = new Deflater();
    deflater.setInput(plain);
    deflater.finish();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    byte[] chunk = new byte[CHUNK];
    while (!deflater.finished()) {
      out.write(chunk, 0, deflater.deflate(chunk));
    }
    deflater.end();
    return out.toByteArray();
  }
}
