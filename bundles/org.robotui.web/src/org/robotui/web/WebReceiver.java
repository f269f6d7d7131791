package org.robotui.web;

import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.robotui.net.log.PeerText;

/** Takes parts of messages from a socket and hands over whole ones. The socket calls it one call at a time. */
final class WebReceiver implements WebSocket.Listener {

  private final WebListener listener;
  private final int longest;
  private final Assembly assembly;
  private final CompletableFuture<String> ended = new CompletableFuture<>();
  private final CompletableFuture<LinkHeartbeat> heartbeat = new CompletableFuture<>();

  WebReceiver(WebListener listener, int longest) {
    this.listener = listener;
    this.longest = longest;
    this.assembly = new Assembly(longest);
  }

  CompletableFuture<String> ended() {
    return ended;
  }

  /** Of the socket that has been opened. */
  LinkHeartbeat heartbeat() {
    return heartbeat.join();
  }

  @Override
  public void onOpen(WebSocket socket) {
    heartbeat.complete(new LinkHeartbeat(socket));
    socket.request(1);
  }

  @Override
  public CompletionStage<?> onText(WebSocket socket, CharSequence part, boolean last) {
    heartbeat().heard(System.nanoTime());
    assembly.text(part, last).ifPresent(listener::onText);
    return after(socket, last);
  }

  @Override
  public CompletionStage<?> onBinary(WebSocket socket, ByteBuffer part, boolean last) {
    heartbeat().heard(System.nanoTime());
    assembly.binary(part, last).ifPresent(listener::onBinary);
    return after(socket, last);
  }

  private CompletionStage<?> after(WebSocket socket, boolean last) {
    if (last && assembly.ended()) {
      listener.onSkipped("a message of more than " + longest + " bytes was passed over");
    }
    socket.request(1);
    return null; // the part may be used again: nothing of it is kept
  }

  @Override
  public CompletionStage<?> onPong(WebSocket socket, ByteBuffer message) {
    heartbeat().answered(System.nanoTime());
    socket.request(1);
    return null;
  }

  @Override
  public CompletionStage<?> onClose(WebSocket socket, int status, String reason) {
    ended.complete("has closed the connection"
        + (reason.isBlank() ? " (" + status + ")" : ": " + PeerText.brief(reason)));
    return null;
  }

  @Override
  public void onError(WebSocket socket, Throwable error) {
    failed(error);
  }

  void failed(Throwable error) {
    ended.complete(WebFaults.reason(error));
  }
}
