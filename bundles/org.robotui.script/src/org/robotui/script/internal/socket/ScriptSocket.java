package org.robotui.script.internal.socket;

import java.io.IOException;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.api.script.Scripts;
import org.robotui.api.script.Scripts.Door;
import org.robotui.net.socket.UserSocket;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Where other programs of this user run scripts: each that comes has a session of its own, as long as it stays. */
public final class ScriptSocket implements Door {
  private static final Logger LOG = LoggerFactory.getLogger(ScriptSocket.class);
  private static final int MOST_CLIENTS = 8;

  private final Scripts scripts;
  private final Set<SocketClient> clients = ConcurrentHashMap.newKeySet();
  private final UserSocket socket;

  private ScriptSocket(Path file, Scripts scripts) throws IOException {
    this.scripts = scripts;
    this.socket = UserSocket.listen(file, ScriptSocket::thread, this::serve);
  }

  /** Listens in a folder, as far as that allows it. */
  public static Optional<Door> open(Path folder, Scripts scripts) {
    Path file = folder.resolve("script-" + ProcessHandle.current().pid() + ".sock");
    try {
      return Optional.of(new ScriptSocket(file, scripts));
    } catch (IOException e) {
      LOG.warn("Programs cannot run scripts here, as {} cannot be made: {}", file, e.toString());
      return Optional.empty();
    }
  }

  static Thread thread(Runnable work) {
    return Thread.ofPlatform().daemon().name("robotui-script-socket").unstarted(work);
  }

  private void serve(SocketChannel channel) {
    SocketClient client = new SocketClient(channel, scripts);
    clients.add(client);
    try {
      if (clients.size() > MOST_CLIENTS) {
        client.refuse("there are already " + MOST_CLIENTS + " programs at this socket");
      } else {
        client.serve();
      }
    } finally {
      client.close();
      clients.remove(client);
    }
  }

  @Override
  public Path file() {
    return socket.file();
  }

  @Override
  public void close() {
    socket.close();
    clients.forEach(SocketClient::close);
  }
}
