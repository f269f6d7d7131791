package org.robotui.testkit.rfic;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A door of TCP before a robot, with an address of its own that stays while robots come and go behind it. It can be
 * shut, so that links break; hold, so that nothing is carried though links stay; and put bytes of its own before those
 * that come from the robot. Safe for all threads.
 */
public final class Gate implements AutoCloseable {
  private static final int CHUNK = 1 << 14;

  private final ServerSocket listening;
  private final Set<Passage> passages = ConcurrentHashMap.newKeySet();
  private boolean holds;
  private boolean closed;
  private int robotPort;

  /**
   * A shut door.
   *
   * @throws IOException where there is no free port
   */
  public Gate() throws IOException {
    listening = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    Peer.THREADS.newThread(this::accept).start();
  }

  /**
   * Where robot interfaces call.
   *
   * @return a port of 127.0.0.1
   */
  public int port() {
    return listening.getLocalPort();
  }

  /**
   * Opens it. Who calls from now on is let through.
   *
   * @param to port of the robot, on 127.0.0.1
   */
  public synchronized void open(int to) {
    robotPort = to;
    goOn();
  }

  /** Shuts it: links break, and who calls finds that the line breaks at once. */
  public void shut() {
    synchronized (this) {
      robotPort = 0;
      goOn();
    }
    passages.forEach(Passage::close);
  }

  /** Carries nothing from now on; links stay, and who calls is taken and gets no answer. */
  public synchronized void hold() {
    holds = true;
  }

  /** Carries again, what was held first. */
  public synchronized void goOn() {
    holds = false;
    notifyAll();
  }

  /**
   * Puts bytes before what comes next from the robot.
   *
   * @param bytes for all who are linked
   */
  public void inject(byte[] bytes) {
    passages.forEach(passage -> passage.inject(bytes));
  }

  /**
   * How many are linked.
   *
   * @return those who have called and not hung up
   */
  public int links() {
    return passages.size();
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    quietly(listening);
    passages.forEach(Passage::close);
  }

  private void accept() {
    try {
      while (true) {
        Passage passage = new Passage(listening.accept());
        passages.add(passage);
        Peer.THREADS.newThread(passage::begin).start();
      }
    } catch (IOException e) {
      // closed
    }
  }

  private synchronized int awaitOpen() throws InterruptedException {
    while (holds && !closed) {
      wait();
    }
    return closed ? 0 : robotPort;
  }

  private static void quietly(AutoCloseable each) {
    try {
      each.close();
    } catch (Exception e) {
      // it is over in any case
    }
  }

  /** One link. */
  private final class Passage {
    private final Socket near;
    private volatile Socket far = new Socket();

    Passage(Socket near) {
      this.near = near;
    }

    void begin() {
      try {
        int to = awaitOpen();
        if (to > 0) {
          far = new Socket(InetAddress.getLoopbackAddress(), to);
          Peer.THREADS.newThread(() -> carry(far, near)).start();
          carry(near, far);
        }
      } catch (IOException | InterruptedException e) {
        // the robot is not there
      } finally {
        close();
      }
    }

    private void carry(Socket from, Socket to) {
      byte[] some = new byte[CHUNK];
      try {
        for (int size = from.getInputStream().read(some); size >= 0; size = from.getInputStream().read(some)) {
          awaitOpen();
          write(to, some, size);
        }
      } catch (IOException | InterruptedException e) {
        // one side is gone
      } finally {
        close();
      }
    }

    private void write(Socket to, byte[] bytes, int size) throws IOException {
      synchronized (to) {
        OutputStream out = to.getOutputStream();
        out.write(bytes, 0, size);
      }
    }

    void inject(byte[] bytes) {
      try {
        write(near, bytes, bytes.length);
      } catch (IOException e) {
        close();
      }
    }

    void close() {
      quietly(near);
      quietly(far);
      passages.remove(this);
    }
  }
}
