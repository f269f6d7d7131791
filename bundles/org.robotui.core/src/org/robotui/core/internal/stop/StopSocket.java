package org.robotui.core.internal.stop;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.net.socket.UserSocket;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Where {@code ./robotui stop} and {@code ./robotui support} reach this process: a socket in the file system that only
 * its user can open. It has threads of its own, so that it needs neither a window nor anything else that may hang. Who
 * says one of its words is answered with some lines, and {@code done} at the end.
 */
public final class StopSocket implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(StopSocket.class);
  private static final int MOST_CHARACTERS = 16;

  private final Map<String, Supplier<List<String>>> words;
  private final Optional<UserSocket> socket;

  /**
   * Listens from now on, as far as the folder allows that.
   *
   * @param folder of the sockets of all processes of this user; need not exist
   * @param words what is done and answered where a word is said, such as {@code stop}; must not wait for anything
   */
  public StopSocket(Path folder, Map<String, Supplier<List<String>>> words) {
    this.words = Map.copyOf(words);
    this.socket = open(folder.resolve("stop-" + ProcessHandle.current().pid() + ".sock"));
  }

  private Optional<UserSocket> open(Path file) {
    try {
      return Optional.of(UserSocket.listen(file, StopSocket::thread, this::serve));
    } catch (IOException e) {
      LOG.warn("./robotui stop cannot reach this process, as {} cannot be made: {}", file, e.toString());
      return Optional.empty();
    }
  }

  private static Thread thread(Runnable work) {
    Thread thread = Thread.ofPlatform().daemon().name("robotui-stop-socket").unstarted(work);
    thread.setPriority(Thread.MAX_PRIORITY);
    return thread;
  }

  private void serve(SocketChannel client) {
    try (client) {
      BufferedReader in =
          new BufferedReader(new InputStreamReader(Channels.newInputStream(client), StandardCharsets.UTF_8));
      Supplier<List<String>> answer = words.get(line(in));
      if (answer != null) {
        OutputStream out = Channels.newOutputStream(client);
        out.write((String.join("\n", answer.get()) + "\ndone\n").getBytes(StandardCharsets.UTF_8));
      }
    } catch (IOException e) {
      LOG.debug("who asked has gone: {}", e.toString());
    }
  }

  /** Never more than a word: what comes is not trusted. */
  private static String line(BufferedReader in) throws IOException {
    StringBuilder word = new StringBuilder();
    for (int c = in.read(); c >= 0 && c != '\n' && word.length() < MOST_CHARACTERS; c = in.read()) {
      word.append((char) c);
    }
    return word.toString();
  }

  @Override
  public void close() {
    socket.ifPresent(UserSocket::close);
  }
}
