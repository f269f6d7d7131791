package org.robotui.carmen.central;

import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.carmen.format.FormatTree;
import org.robotui.carmen.internal.CentralBooks;
import org.robotui.carmen.internal.CentralClient;
import org.robotui.carmen.internal.IpcLinks;
import org.robotui.carmen.internal.SystemMessages;
import org.robotui.carmen.wire.IpcFrame;
import org.robotui.net.link.FrameLink;
import org.robotui.net.socket.Sockets;
import org.robotui.net.socket.TcpListener;
import org.robotui.net.thread.Workers;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A central that is open from its making until it is closed. Safe for all threads. */
public final class IpcCentral implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(IpcCentral.class);
  private static final Duration END = Duration.ofSeconds(2);
  private static final int MOST_MODULES = 256;

  private final Workers workers;
  private final TcpListener listener;
  private final CentralBooks books;
  private final Map<FrameLink<IpcFrame>, CentralClient> modules = new ConcurrentHashMap<>();

  /**
   * Listens at once.
   *
   * @param options where
   * @throws IOException where the port cannot be had
   */
  public IpcCentral(CentralOptions options) throws IOException {
    this.workers = new Workers(options.threads());
    this.books = new CentralBooks(options.direct());
    this.listener = TcpListener.bind(options.address(), options.port());
    String name = "carmen central " + port();
    workers.start(name, () -> listener.acceptAll(name, this::begin));
  }

  /**
   * Where it listens.
   *
   * @return the port that it has
   */
  public int port() {
    return listener.port();
  }

  /**
   * Who handles messages.
   *
   * @return the names of messages, each with those of its modules
   */
  public Map<String, Set<String>> handlers() {
    return books.handlers();
  }

  /**
   * Which modules are linked.
   *
   * @return their names; those that have not introduced themselves yet are left out
   */
  public List<String> modules() {
    return modules.values().stream().map(CentralClient::name).filter(name -> !name.isEmpty()).toList();
  }

  private void begin(Socket socket) throws IOException {
    if (modules.size() >= MOST_MODULES) {
      throw new IOException("there are " + MOST_MODULES + " modules already");
    }
    Sockets.prepare(socket);
    FrameLink<IpcFrame> link = IpcLinks.of(socket, new FromModule());
    modules.put(link, new CentralClient(link));
    link.send(ByteBuffer.allocate(Integer.BYTES).putInt(CentralBooks.INFO_ID).array());
    link.send(greeting(FormatTree.bytes(SystemMessages.ASK_INFO.format(), ByteOrder.LITTLE_ENDIAN)));
    link.send(greeting(FormatTree.bytes(SystemMessages.INFO.format(), ByteOrder.LITTLE_ENDIAN)));
    link.start(workers, "carmen module " + socket.getRemoteSocketAddress());
    if (listener.isClosed()) {
      link.close();
    }
  }

  private static IpcFrame greeting(byte[] body) {
    return new IpcFrame(0, 0, IpcFrame.SYSTEM, 0, 0, "", ByteOrder.LITTLE_ENDIAN, ByteBuffer.wrap(body));
  }

  private final class FromModule implements FrameLink.Receiver<IpcFrame> {
    @Override
    public void received(IpcFrame frame, FrameLink<IpcFrame> link) throws IOException {
      CentralClient client = modules.get(link);
      if (client != null) {
        books.take(client, frame);
      }
    }

    @Override
    public void ended(FrameLink<IpcFrame> link, String reason) {
      CentralClient client = modules.remove(link);
      if (client != null) {
        LOG.debug("module {} is gone: {}", client.name(), reason);
        books.gone(client);
      }
    }
  }

  /** Ends all links. */
  @Override
  public void close() {
    listener.close();
    modules.keySet().forEach(FrameLink::close);
    workers.join(System.nanoTime() + END.toNanos());
  }
}
