package org.robotui.carmen.module;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.carmen.internal.IpcLinks;
import org.robotui.carmen.internal.SystemMessages;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.wire.IpcFrame;
import org.robotui.net.link.FrameLink;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.net.socket.TcpListener;
import org.robotui.net.thread.Workers;

/** The links of a module to other modules, where the central says that they talk to each other. */
final class DirectLinks implements Closeable, FrameLink.Receiver<IpcFrame> {

  /** More links are no robot's. */
  private static final int MOST = 64;

  private final IpcModule module;
  private final Workers workers;
  private final ModuleOptions options;
  private final InetAddress local;
  private final Map<HostPort, FrameLink<IpcFrame>> called = new ConcurrentHashMap<>();
  private final CloseableSet open = new CloseableSet();
  private volatile Optional<TcpListener> listener = Optional.empty();

  /** Somebody who handles a message. */
  record Handler(int number, FrameLink<IpcFrame> link) {}

  DirectLinks(IpcModule module, Workers workers, ModuleOptions options, InetAddress local) {
    this.module = module;
    this.workers = workers;
    this.options = options;
    this.local = local;
  }

  boolean listens() {
    return listener.isPresent();
  }

  /** Begins to listen for others; gives the port. */
  int listen() throws IOException {
    TcpListener opened = TcpListener.bind(local, 0);
    listener = Optional.of(opened);
    workers.start("carmen module " + opened.port(), () -> opened.acceptAll("carmen module", this::accept));
    return opened.port();
  }

  private void accept(Socket socket) throws IOException {
    if (open.size() >= MOST) {
      throw new IOException("there are " + MOST + " links already");
    }
    Sockets.prepare(socket);
    begin(IpcLinks.of(socket, this), "carmen module " + socket.getRemoteSocketAddress());
  }

  private void begin(FrameLink<IpcFrame> link, String name) {
    if (open.add(link)) {
      link.start(workers, name);
    }
  }

  /** Asks who handles a message, and calls those who are not called yet; this blocks. */
  List<Handler> handlers(String message) throws IOException {
    IpcRecord question = SystemMessages.ASK_DIRECT.make().text("message", message).build();
    IpcFrame answer = module.askSystem(SystemMessages.ASK_DIRECT, question);
    List<Handler> handlers = new ArrayList<>();
    if (answer.body().hasRemaining()) {
      for (IpcRecord each : SystemMessages.DIRECT_HANDLERS.readBare(answer.body()).records("handlers")) {
        handlers.add(new Handler(each.whole("handler"), call(new HostPort(each.text("host"), each.whole("port")))));
      }
    }
    return handlers;
  }

  private FrameLink<IpcFrame> call(HostPort peer) throws IOException {
    FrameLink<IpcFrame> known = called.get(peer);
    if (known != null && !known.isOver()) {
      return known;
    }
    Socket socket = options.sockets().createSocket();
    try {
      Sockets.minimizeSendBuffer(socket);
      reachable(peer).connect(socket, options.patience());
      Sockets.prepare(socket);
      FrameLink<IpcFrame> link = IpcLinks.of(socket, this);
      called.put(peer, link);
      begin(link, "carmen module " + peer);
      return link;
    } catch (IOException | RuntimeException e) {
      Sockets.closeQuietly(socket);
      throw e;
    }
  }

  /** Names of hosts are those that the modules gave: what is not known here is taken to be where the central is. */
  private HostPort reachable(HostPort peer) {
    try {
      peer.resolve();
      return peer;
    } catch (UnknownHostException e) {
      return new HostPort(module.central().host(), peer.port());
    }
  }

  @Override
  public void received(IpcFrame frame, FrameLink<IpcFrame> link) {
    if (frame.intent() == IpcFrame.REPLY_INTENT) {
      module.pending().answered(frame.reference(), frame);
    } else if (frame.intent() > 0) {
      module.deliver(frame, link);
    }
  }

  @Override
  public void ended(FrameLink<IpcFrame> link, String reason) {
    open.forget(link);
    called.values().remove(link);
  }

  @Override
  public void close() {
    listener.ifPresent(TcpListener::close);
    open.close();
  }
}
