package org.robotui.guard.internal.process;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;

/** Says one farewell: connects, sends, and reads the answer until its end. */
final class Call implements Handler {
  private static final int MOST_ANSWER = 64 * 1024;

  private final SocketChannel channel;
  private final InetSocketAddress to;
  private final ByteBuffer words;
  private final ByteBuffer answer = ByteBuffer.allocate(4 * 1024);
  private final long deadline;
  private final Calls calls;
  private int answered;

  Call(Selector selector, Calls.Farewell farewell, long deadline, Calls calls) throws IOException {
    this.to = farewell.to();
    this.words = ByteBuffer.wrap(farewell.words());
    this.deadline = deadline;
    this.calls = calls;
    this.channel = SocketChannel.open();
    try {
      channel.configureBlocking(false);
      channel.connect(to);
      channel.register(selector, SelectionKey.OP_CONNECT, this);
    } catch (IOException | RuntimeException e) {
      Channels.quietly(channel);
      throw e;
    }
  }

  InetSocketAddress to() {
    return to;
  }

  @Override
  public void ready(SelectionKey key) throws IOException {
    if (key.isConnectable()) {
      channel.finishConnect();
    }
    if (words.hasRemaining()) {
      channel.write(words);
      key.interestOps(words.hasRemaining() ? SelectionKey.OP_WRITE : SelectionKey.OP_READ);
      return;
    }
    int count = channel.read(answer.clear());
    answered += Math.max(0, count);
    if (count < 0 || answered > MOST_ANSWER) {
      end(true);
    }
  }

  @Override
  public void tick(long now) {
    if (now - deadline > 0) {
      end(answered > 0);
    }
  }

  private void end(boolean heard) {
    Channels.quietly(channel);
    calls.ended(this, heard);
  }

  @Override
  public void close() {
    end(false);
  }
}
