package org.robotui.rfic.ros.internal;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.time.Duration;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;

/** A line to a master that brings each question late, as over a bad network or to a master that has much to do. */
final class SlowLine implements Closeable {
  private final ServerSocket listening;
  private final int to;
  private final Set<Closeable> open = ConcurrentHashMap.newKeySet();
  private volatile Duration delay = Duration.ZERO;

  SlowLine(URI master) throws IOException {
    listening = new ServerSocket(0, 500, InetAddress.getLoopbackAddress());
    to = master.getPort();
    RosRficCase.DAEMONS.newThread(this::accept).start();
  }

  String uri() {
    return "http://127.0.0.1:" + listening.getLocalPort();
  }

  void delay(Duration each) {
    delay = each;
  }

  private void accept() {
    try {
      while (true) {
        Socket caller = listening.accept();
        Socket master = new Socket(InetAddress.getLoopbackAddress(), to);
        open.add(caller);
        open.add(master);
        RosRficCase.DAEMONS.newThread(() -> carry(caller, master, true)).start();
        RosRficCase.DAEMONS.newThread(() -> carry(master, caller, false)).start();
      }
    } catch (IOException e) {
      // it is closed
    }
  }

  private void carry(Socket from, Socket into, boolean late) {
    byte[] some = new byte[1 << 16];
    try (from; into) {
      InputStream in = from.getInputStream();
      OutputStream out = into.getOutputStream();
      for (int count = in.read(some); count >= 0; count = in.read(some)) {
        if (late) {
          LockSupport.parkNanos(delay.toNanos());
        }
        out.write(some, 0, count);
      }
    } catch (IOException e) {
      // one of them hung up
    } finally {
      open.remove(from);
      open.remove(into);
    }
  }

  @Override
  public void close() {
    try {
      listening.close();
      for (Closeable each : open) {
        each.close();
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
