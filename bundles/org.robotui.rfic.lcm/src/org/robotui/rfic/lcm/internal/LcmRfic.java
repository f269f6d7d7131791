package org.robotui.rfic.lcm.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import javax.net.SocketFactory;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficWorker;
import org.robotui.api.link.LinkState;
import org.robotui.guard.Guard;
import org.robotui.guard.Guards;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.rfic.lcm.internal.session.Session;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Robots that speak LCM at one URL. One thread of its own reads the types, opens the connection and watches it. */
final class LcmRfic implements Rfic {
  private static final Logger LOG = LoggerFactory.getLogger(LcmRfic.class);
  private static final Duration RETRY = Duration.ofSeconds(3);
  private static final Duration END = Duration.ofMillis(1500);

  private final RficContext context;
  private final LcmSettings settings;
  private final Guards guards;
  private final RficWorker worker;
  private final AtomicReference<Session> session = new AtomicReference<>();

  LcmRfic(RficContext context, LcmSettings settings, Guards guards) {
    this.context = context;
    this.settings = settings;
    this.guards = guards;
    this.worker = new RficWorker(context, RETRY, this::follow);
  }

  @Override
  public void start() {
    worker.start(settings.url().toString());
  }

  private String follow(BooleanSupplier over) throws IOException, InterruptedException {
    return settings.guard() ? guarded(over) : follow(SocketFactory.getDefault(), over);
  }

  private String guarded(BooleanSupplier over) throws IOException, InterruptedException {
    try (Guard guard = guards.open()) {
      return follow(guard.sockets(), over);
    }
  }

  private String follow(SocketFactory sockets, BooleanSupplier over) throws IOException, InterruptedException {
    // a recording would begin anew, or be written over
    boolean watched = !settings.url().provider().equals("file");
    TypeFiles files = new TypeFiles(watched ? settings.types() : List.of());
    while (true) {
      boolean[] changed = {false};
      files.reading(System.nanoTime());
      try (Session opened = new Session(context, settings, TypeFolder.read(settings.types()), sockets)) {
        session.set(opened);
        String end = opened.follow(() -> over.getAsBoolean() || (changed[0] = files.changed(System.nanoTime())));
        if (!changed[0]) {
          return end;
        }
      }
      LOG.info("{}: .lcm files have changed and are read anew", context.instance());
    }
  }

  @Override
  public void close() {
    worker.stop();
    Session opened = session.get();
    if (opened != null) {
      opened.close();
    }
    if (!worker.join(END)) {
      LOG.warn("{} did not end in {} ms", context.instance(), END.toMillis());
    }
    context.link().report(new LinkState.Disconnected());
  }
}
