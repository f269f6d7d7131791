package org.robotui.rtps.internal.wire;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Datagrams as two programs of a vendor exchanged them: a talker and a listener with small samples, large ones in
 * fragments, a kept one, and with Fast DDS (ROS 2 Kilted) a service. Each stands behind its length in four bytes.
 */
public enum Recorded {
  FAST_DDS("fast-dds.bin"), CYCLONE_DDS("cyclone-dds.bin");

  private final String file;

  Recorded(String file) {
    this.file = file;
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
}
