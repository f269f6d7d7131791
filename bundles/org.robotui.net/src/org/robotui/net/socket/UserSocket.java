package org.robotui.net.socket;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.concurrent.ThreadFactory;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A socket in the file system that only its user can open: where other programs of this user reach this process. It has
 * threads of its own, one that listens and one for each client. Safe for all threads.
 */
public final class UserSocket implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(UserSocket.class);

  private final Path file;
  private final ServerSocketChannel server;

  private UserSocket(Path file, ServerSocketChannel server) {
    this.file = file;
    this.server = server;
  }

  /**
   * Listens from now on.
   *
   * @param file the socket; one that is there already is of a process that has ended, and is replaced. Its folder need
   * not exist, and is closed to other users
   * @param threads makes the threads
   * @param client talks with one client on a thread of its own, and closes the channel
   * @return the socket
   * @throws IOException where it cannot be made, also where the system has no such sockets
   */
  public static UserSocket listen(Path file, ThreadFactory threads, Consumer<SocketChannel> client)
      throws IOException {
    try {
      privateFolder(file.getParent());
      Files.deleteIfExists(file);
      ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
      server.bind(UnixDomainSocketAddress.of(file));
      Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
      UserSocket socket = new UserSocket(file, server);
      threads.newThread(() -> socket.accept(threads, client)).start();
      return socket;
    } catch (UnsupportedOperationException e) {
      throw new IOException(e);
    }
  }

  /**
   * Makes a folder where there is none; closes it to others.
   *
   * @param folder the folder
   * @throws IOException where that cannot be done
   */
  public static void privateFolder(Path folder) throws IOException {
    Files.createDirectories(folder);
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwx------"));
  }

  /**
   * Where it is.
   *
   * @return the file
   */
  public Path file() {
    return file;
  }

  private void accept(ThreadFactory threads, Consumer<SocketChannel> client) {
    while (server.isOpen()) {
      try {
        SocketChannel came = server.accept();
        threads.newThread(() -> client.accept(came)).start();
      } catch (IOException e) {
        LOG.debug("{} is closed: {}", file, e.toString());
      }
    }
  }

  /** Listens no more; who talks goes on. */
  @Override
  public void close() {
    try {
      server.close();
      Files.deleteIfExists(file);
    } catch (IOException e) {
      LOG.debug("{} stays: {}", file, e.toString());
    }
  }
}
