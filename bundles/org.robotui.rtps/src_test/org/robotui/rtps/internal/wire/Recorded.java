package org.robotui.rtps.internal.wire;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Datagrams as two programs of a vendor exchanged them: a talker and a listener with small samples, large ones in
 * fragments, a kept one, and with Fast DDS (ROS 2 Kilted) a service. Each stands behind its length in four bytes.
 */
public enum Recorded {
  FAST_DDS("fast-dds.bin", 41), CYCLONE_DDS("cyclone-dds.bin", 42);

  private final String file;

  private final int domain;

  Recorded(String file, int domain) {
    this.file = file;
    this.domain = domain;
  }

  public List<byte[]> datagrams() {
    List<byte[]> all = new ArrayList<>();
    try (InputStream stream = Recorded.class.getResourceAsStream(file)) {
      DataInputStream in = new DataInputStream(stream);
      while (in.available() > 0) {
        all.add(in.readNBytes(in.readInt()));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return all;
  }

  /** The same ones, addressed to whoever hears them, so that no part is left out, and of another domain. */
  public List<byte[]> toAll(int mostBytes, int hearers) {
    List<byte[]> all = datagrams().stream().filter(datagram -> datagram.length < mostBytes).toList();
    for (byte[] datagram : all) {
      inDomain(datagram, hearers);
      for (int at = 20; at + 4 <= datagram.length;) {
        int length = Short.toUnsignedInt(ByteBuffer.wrap(datagram).order(ByteOrder.LITTLE_ENDIAN).getShort(at + 2));
        if (datagram[at] == SubmessageId.INFO_DST) {
          Arrays.fill(datagram, at + 4, at + 16, (byte) 0);
        }
        at += length == 0 && datagram[at] != SubmessageId.INFO_TS ? datagram.length : 4 + length;
      }
    }
    return all;
  }

  private void inDomain(byte[] datagram, int hearers) {
    byte[] parameter = {0x0f, 0, 4, 0, (byte) domain, 0, 0, 0};
    for (int at = 0; at + parameter.length <= datagram.length; at++) {
      if (Arrays.equals(datagram, at, at + parameter.length, parameter, 0, parameter.length)) {
        datagram[at + 4] = (byte) hearers;
      }
    }
  }
}
