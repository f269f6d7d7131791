package org.robotui.core.internal.stop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StopSocketTest {
  private final AtomicInteger stops = new AtomicInteger();
  @TempDir
  private Path folder;

  private Path file() {
    return folder.resolve("run").resolve("stop-" + ProcessHandle.current().pid() + ".sock");
  }

  private StopSocket open() {
    return new StopSocket(folder.resolve("run"), Map.of("stop", () -> {
      stops.incrementAndGet();
      return List.of("Keira: stopped", "Natalie: stopped");
    }));
  }

  private String say(String words) throws IOException {
    try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(file()))) {
      Channels.newOutputStream(channel).write(words.getBytes(StandardCharsets.UTF_8));
      channel.shutdownOutput();
      return new String(Channels.newInputStream(channel).readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @Test
  void whoSaysStopIsToldWhatWasStopped() throws IOException {
    try (StopSocket socket = open()) {
      assertEquals("Keira: stopped\nNatalie: stopped\ndone\n", say("stop\n"));
      assertEquals("Keira: stopped\nNatalie: stopped\ndone\n", say("stop\n"));
      assertEquals(2, stops.get());
    }
    assertFalse(Files.exists(file()));
  }

  @Test
  void otherWordsAndFloodsDoNothing() throws IOException {
    try (StopSocket socket = open()) {
      assertEquals("", say(""));
      assertEquals("", say("go\n"));
      assertEquals("", say("stopstopstopstop"));
      assertEquals(0, stops.get());
    }
  }

  @Test
  void whoSaysNothingHoldsNobodyUp() throws IOException {
    try (StopSocket socket = open(); SocketChannel silent = SocketChannel.open(UnixDomainSocketAddress.of(file()))) {
      assertEquals("Keira: stopped\nNatalie: stopped\ndone\n", say("stop\n"));
    }
  }

  @Test
  void onlyItsUserMayOpenIt() throws IOException {
    try (StopSocket socket = open()) {
      assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file())));
      assertEquals("rwx------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file().getParent())));
    }
  }
}
