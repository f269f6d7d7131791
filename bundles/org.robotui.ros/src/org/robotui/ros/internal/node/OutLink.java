package org.robotui.ros.internal.node;

import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.robotui.message.MessageInfo;
import org.robotui.net.socket.Sockets;
import org.robotui.ros.GraphName;
import org.robotui.ros.LinkEvent.Kind;
import org.robotui.ros.LinkState;
import org.robotui.ros.internal.tcpros.FrameReader;
import org.robotui.ros.internal.tcpros.FrameWriter;
import org.robotui.ros.internal.tcpros.OutQueue;

/** A link to one subscriber: one thread writes what waits in the queue, another one notices when the peer goes away. */
record OutLink(NodeContext context, GraphName topic, String subscriber, MessageInfo theirs, Socket socket,
    OutQueue queue,
    Traffic sent) {

  void offer(ByteBuffer frame) {
    queue.offer(frame);
  }

  /** Puts a frame in the place of those that wait. */
  void offerUrgently(ByteBuffer frame) {
    queue.offerAlone(frame);
  }

  /** Whether all frames were handed to the network. */
  boolean isIdle() {
    return queue.isIdle();
  }

  /** Runs until the link ends; the calling thread is the one that listens for the peer's end. */
  void run(FrameReader in) throws IOException {
    report(new LinkState.Connected(subscriber, theirs));
    context.start("pub " + topic + " " + subscriber, this::write);
    try {
      in.nextByte("the end of the link");
      throw new IOException("the subscriber sent bytes where none belong");
    } catch (IOException e) {
      report(new LinkState.Closed("topic " + topic + ": subscriber " + subscriber + ": " + e.getMessage()));
    } finally {
      close();
    }
  }

  private void write() {
    List<ByteBuffer> batch = new ArrayList<>();
    try {
      FrameWriter out = new FrameWriter(socket.getOutputStream());
      while (queue.take(batch)) {
        long bytes = 0;
        for (ByteBuffer frame : batch) {
          bytes += frame.remaining();
          out.write(frame);
        }
        out.flush();
        sent.count(batch.size(), bytes);
        batch.clear();
      }
    } catch (IOException e) {
      // closing the socket ends the other thread, which reports the end
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      close();
    }
  }

  void close() {
    queue.close();
    Sockets.closeQuietly(socket);
  }

  private void report(LinkState state) {
    context.report(Kind.PUBLICATION, topic.text(), subscriber, state);
  }
}
