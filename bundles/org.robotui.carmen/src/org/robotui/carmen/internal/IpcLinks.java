package org.robotui.carmen.internal;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import org.robotui.carmen.wire.IpcFrame;
import org.robotui.carmen.wire.IpcFraming;
import org.robotui.net.link.FrameLink;
import org.robotui.net.link.Framing;

/** Makes connections that carry frames of IPC. */
public final class IpcLinks {

  private static final Framing<IpcFrame> FRAMING = new Framing<>() {
    @Override
    public IpcFrame read(InputStream in) throws IOException {
      return IpcFraming.read(in);
    }

    @Override
    public byte[] bytes(IpcFrame frame) {
      return IpcFraming.bytes(frame);
    }
  };

  private IpcLinks() {}

  /** Of a socket that is connected. */
  public static FrameLink<IpcFrame> of(Socket socket, FrameLink.Receiver<IpcFrame> receiver) throws IOException {
    return new FrameLink<>(socket, FRAMING, receiver);
  }
}
