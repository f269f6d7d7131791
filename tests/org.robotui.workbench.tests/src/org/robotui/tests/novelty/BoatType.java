package org.robotui.tests.novelty;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.GpsFix;

/** A boat that lies at anchor: it sends how deep the water is, and where on the earth it is. */
final class BoatType implements RficType {
  private static final StreamPort<WaterDepth> DEPTH =
      new StreamPort<>("depth", WaterDepth.class, Arity.MANY, "How deep the water is.");
  private static final StreamPort<GpsFix> FIX = new StreamPort<>("fix", GpsFix.class, Arity.MANY, "Where it is.");
  private static final double LATITUDE = 0.9;
  private static final double LONGITUDE = 0.2;
  private static final long PERIOD_NANOS = 100_000_000L;

  @Override
  public Descriptor descriptor() {
    return new Descriptor("boat", "Boat", "A robot of the tests.", Schema.EMPTY, List.of(DEPTH, FIX));
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return new Rfic() {
      @Override
      public void start() {
        Publication<WaterDepth> depth = context.offers().stream(DEPTH, Demand.IGNORED);
        Publication<GpsFix> fix = context.offers().stream(FIX, Demand.IGNORED);
        context.link().report(new LinkState.Connected("boat"));
        context.threads().newThread(() -> send(new FrameId(context.robot(), "sounder"), depth, fix)).start();
      }

      @Override
      public void close() {
        // Its thread is interrupted by who made it.
      }
    };
  }

  private static void send(FrameId frame, Publication<WaterDepth> depth, Publication<GpsFix> fix) {
    while (!Thread.currentThread().isInterrupted()) {
      depth.publish(new WaterDepth(frame, LATITUDE, LONGITUDE, 4), Optional.empty());
      fix.publish(new GpsFix(frame, GpsFix.Quality.FIX, LATITUDE, LONGITUDE, 0, 1), Optional.empty());
      LockSupport.parkNanos(PERIOD_NANOS);
    }
  }
}
