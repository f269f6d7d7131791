package org.robotui.rfic.xbot.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficWorker;
import org.robotui.api.link.LinkState;
import org.robotui.xbot.RtClient;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A control of this machine. One thread of its own attaches to it, reads it at a rate, and attaches again when it was restarted. */
final class XbotRfic implements Rfic {
  private static final Logger LOG = LoggerFactory.getLogger(XbotRfic.class);
  private static final Duration RETRY = Duration.ofSeconds(1);
  private static final Duration END = Duration.ofMillis(1500);

  private final RficContext context;
  private final XbotSettings settings;
  private final RficWorker worker;

  XbotRfic(RficContext context, XbotSettings settings) {
    this.context = context;
    this.settings = settings;
    this.worker = new RficWorker(context, RETRY, this::follow);
  }

  @Override
  public void start() {
    worker.start("the real-time control of " + settings.robot());
  }

  private String follow(BooleanSupplier over) throws IOException, InterruptedException {
    try (RtClient client = RtClient.connect(settings.robot());
        Session session = new Session(context, settings, client)) {
      return session.follow(over);
    }
  }

  @Override
  public void close() {
    worker.stop();
    if (!worker.join(END)) {
      LOG.warn("{} did not end in {} ms", context.instance(), END.toMillis());
    }
    context.link().report(new LinkState.Disconnected());
  }
}
