package org.robotui.net.process;

import java.io.IOException;
import java.io.InputStream;
import java.net.ConnectException;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/**
 * What a process of this user said when it was asked by its socket in the file system. Sockets carry the number of
 * their process in their names, as {@code stop-4711.sock}.
 *
 * @param process its number
 * @param runs whether there is such a process; one that hangs as a whole takes the connection, since the kernel does,
 * but never answers
 * @param text what it said, empty where it said nothing in time
 */
public record SocketAnswer(String process, boolean runs, String text) {
  /** No answer is longer than that, in bytes. */
  static final int MOST = 8 << 20;

  /**
   * Asks all processes of a folder at the same time. Sockets of processes that were killed are removed. Blocks.
   *
   * @param folder of the sockets; need not exist
   * @param pattern which of them, as {@code stop-*.sock}
   * @param word a line
   * @param limit how long each may take
   * @return what those say that run, in no particular order
   * @throws IOException where the folder cannot be read
   */
  public static List<SocketAnswer> ask(Path folder, String pattern, String word, Duration limit) throws IOException {
    List<CompletableFuture<SocketAnswer>> asked = new ArrayList<>();
    if (Files.isDirectory(folder)) {
      try (DirectoryStream<Path> found = Files.newDirectoryStream(folder, pattern)) {
        found.forEach(socket -> asked.add(ask(socket, word, limit)));
      }
    }
    return asked.stream().map(CompletableFuture::join).filter(SocketAnswer::runs).toList();
  }

  private static CompletableFuture<SocketAnswer> ask(Path socket, String word, Duration limit) {
    String process = socket.getFileName().toString().replaceAll("\\D", "");
    CompletableFuture<SocketAnswer> answer = new CompletableFuture<>();
    Thread.ofPlatform().daemon().start(() -> answer.complete(talk(socket, process, word)));
    return answer.completeOnTimeout(new SocketAnswer(process, true, ""), limit.toNanos(), TimeUnit.NANOSECONDS);
  }

  private static SocketAnswer talk(Path socket, String process, String word) {
    try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket));
        InputStream in = Channels.newInputStream(channel)) {
      Channels.newOutputStream(channel).write((word + "\n").getBytes(StandardCharsets.UTF_8));
      return new SocketAnswer(process, true, new String(in.readNBytes(MOST), StandardCharsets.UTF_8));
    } catch (ConnectException e) {
      forget(socket);
      return new SocketAnswer(process, false, "");
    } catch (IOException e) {
      return new SocketAnswer(process, true, "");
    }
  }

  private static void forget(Path socket) {
    try {
      Files.deleteIfExists(socket);
    } catch (IOException e) {
      socket.toFile().deleteOnExit();
    }
  }
}
