package org.robotui.script.internal.socket;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptSession;
import org.robotui.api.script.ScriptSession.Completion;
import org.robotui.api.script.ScriptSource;
import org.robotui.api.script.Scripts;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One program at the socket: a JSON object a line in both directions, as docs/scripting.md describes. What it sends is
 * bounded, and what it does not read holds up nobody but its own script.
 */
final class SocketClient {
  private static final Logger LOG = LoggerFactory.getLogger(SocketClient.class);
  private static final int LONGEST_LINE = 1 << 20;
  private static final int LONGEST_ANSWER = 32 << 20;
  private static final int MOST_WAITING = 32;

  private final SocketChannel channel;
  private final ScriptSession session;
  private final AtomicInteger waiting = new AtomicInteger();
  /** A script is stopped by interrupting its thread, and a channel closes when a thread is interrupted that writes. */
  private final ExecutorService writer = Executors.newSingleThreadExecutor(ScriptSocket::thread);

  SocketClient(SocketChannel channel, Scripts scripts) {
    this.channel = channel;
    this.session = scripts.open("a program at the script socket", this::print);
  }

  /** Until the program goes. */
  void serve() {
    try {
      LineReader lines = new LineReader(channel, LONGEST_LINE);
      for (Optional<String> line = lines.next(); line.isPresent(); line = lines.next()) {
        take(line.get());
      }
    } catch (LineReader.TooLongException e) {
      refuse(e.getMessage());
    } catch (IOException e) {
      LOG.debug("a program at the script socket has gone: {}", e.toString());
    }
  }

  /** Says what is wrong, as an answer to nothing. */
  void refuse(String reason) {
    send(0L, "error", reason);
  }

  private void take(String line) {
    try {
      if (JsonText.read(line) instanceof Map<?, ?> request) {
        take(request, request.get("id") instanceof Long id ? id : 0L);
      } else {
        refuse("a request is an object such as {\"id\": 1, \"run\": \"uis()\"}");
      }
    } catch (TreeException e) {
      refuse(e.getMessage());
    }
  }

  private void take(Map<?, ?> request, long id) {
    if (request.get("run") instanceof String text) {
      run(id, new ScriptSource(request.get("name") instanceof String name ? name : "script", text));
    } else if (request.get("complete") instanceof String line) {
      Completion completion = session.complete(line);
      Map<String, Object> all = answerTo(id);
      all.put("start", completion.start());
      all.put("words", completion.words());
      send(all);
    } else if (Boolean.TRUE.equals(request.get("stop"))) {
      session.stop("it was stopped by its program");
      send(id, "stopping", true);
    } else {
      send(id, "error", "a request has one of: run (a text), complete (a text), stop (true)");
    }
  }

  private void run(long id, ScriptSource source) {
    if (waiting.incrementAndGet() > MOST_WAITING) {
      waiting.decrementAndGet();
      send(id, "error", MOST_WAITING + " scripts wait already");
      return;
    }
    session.run(source).whenComplete((outcome, never) -> {
      waiting.decrementAndGet();
      send(answer(id, outcome));
    });
  }

  private static Map<String, Object> answer(long id, ScriptOutcome outcome) {
    Map<String, Object> all = answerTo(id);
    switch (outcome) {
      case ScriptOutcome.Done done -> {
        all.put("value", done.value().orElse(null));
        all.put("text", done.text());
      }
      case ScriptOutcome.Exited exited -> all.put("exit", exited.code());
      case ScriptOutcome.Failed failed -> error(all, "error", failed.reason(), failed.source(), failed.line());
      case ScriptOutcome.Stopped stopped -> error(all, "stopped", stopped.reason(), stopped.source(), stopped.line());
    }
    return all;
  }

  /** The keys stand in the order in which they are put, so that an answer reads alike each time. */
  private static Map<String, Object> answerTo(long id) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("id", id);
    return all;
  }

  private static void error(Map<String, Object> all, String word, String reason, String source, int line) {
    all.put(word, reason);
    all.put("source", source);
    all.put("line", line);
  }

  private void print(String text) {
    send(0L, "print", text);
  }

  private void send(long id, String word, Object value) {
    Map<String, Object> all = answerTo(id);
    all.put(word, value);
    send(all);
  }

  private void send(Map<String, Object> answer) {
    try {
      String line = JsonText.write(answer);
      write(line.length() <= LONGEST_ANSWER ? line
          : unsent(answer, "it would have more than " + LONGEST_ANSWER + " characters"));
    } catch (IllegalArgumentException e) { // a value for which JSON has no word, such as a function
      write(unsent(answer, e.getMessage()));
    }
  }

  private static String unsent(Map<String, Object> answer, String why) {
    Map<String, Object> all = answerTo((Long) answer.get("id"));
    all.put("error", "the value cannot be sent: " + why);
    return JsonText.write(all);
  }

  /** Waits until it is written, so that a script does not print faster than its program reads. */
  private void write(String line) {
    try {
      writer.submit(() -> transmit(line)).get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // the script is stopped, and asks for this next
    } catch (ExecutionException | RejectedExecutionException e) {
      LOG.debug("a program at the script socket is told no more: {}", e.toString());
    }
  }

  private void transmit(String line) {
    try {
      ByteBuffer bytes = ByteBuffer.wrap((line + "\n").getBytes(StandardCharsets.UTF_8));
      while (bytes.hasRemaining()) {
        channel.write(bytes);
      }
    } catch (IOException e) {
      LOG.debug("a program at the script socket does not read: {}", e.toString());
    }
  }

  /** It has gone, or is sent away: what it moved is stopped. */
  void close() {
    session.close();
    writer.shutdown();
    try {
      channel.close();
    } catch (IOException e) {
      LOG.debug("the channel of a program is not closed: {}", e.toString());
    }
  }
}
