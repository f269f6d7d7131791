package org.robotui.web;

import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;

/** A message that is sent. */
public sealed interface WebPayload {

  /**
   * How much it is.
   *
   * @return bytes
   */
  int size();

  /**
   * Hands it to a socket.
   *
   * @param socket on which nothing else is being sent
   * @return done when the network has it
   */
  CompletableFuture<WebSocket> send(WebSocket socket);

  /**
   * A text.
   *
   * @param text the message
   */
  record Text(String text) implements WebPayload {
    @Override
    public int size() {
      return text.getBytes(StandardCharsets.UTF_8).length;
    }

    @Override
    public CompletableFuture<WebSocket> send(WebSocket socket) {
      return socket.sendText(text, true);
    }
  }

  /**
   * Bytes.
   *
   * @param bytes the message, from position to limit; not to be written to any more
   */
  record Binary(ByteBuffer bytes) implements WebPayload {
    @Override
    public int size() {
      return bytes.remaining();
    }

    @Override
    public CompletableFuture<WebSocket> send(WebSocket socket) {
      return socket.sendBinary(bytes.duplicate(), true);
    }
  }
}
