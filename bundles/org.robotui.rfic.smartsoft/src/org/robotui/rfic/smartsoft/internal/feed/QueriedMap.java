package org.robotui.rfic.smartsoft.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.session.AskedStream;
import org.robotui.data.navigation.GridMap;
import org.robotui.message.MessageException;
import org.robotui.rfic.smartsoft.internal.convert.SmartSensing;
import org.robotui.smartsoft.client.QueryClient;
import org.robotui.smartsoft.naming.NamedService;
import org.robotui.smartsoft.object.CommType;

/** A map that is asked for by queries, which name an area: thirty metres to each side around its origin. */
record QueriedMap(SmartShared shared, QueryClient client, CommType request, CommType answer)
    implements AskedStream.Source<GridMap> {
  private static final Duration PATIENCE = Duration.ofMillis(1500);
  private static final int SIDE = 30_000;
  /** In millimetres; where the map is of what is around the robot, with what was known before. */
  private static final Map<String, Object> AREA = Map.of("xOffsetMM", -SIDE, "yOffsetMM", -SIDE, "xSizeMM", 2 * SIDE,
      "ySizeMM", 2 * SIDE, "curLtmState", true);

  static QueriedMap open(SmartShared shared, NamedService service) throws IOException {
    return new QueriedMap(shared, QueryClient.connect(service.address(), shared.links()),
        shared.types().get(service.name().types().getFirst()), shared.types().get(service.name().types().getLast()));
  }

  @Override
  public Optional<GridMap> ask() throws IOException {
    try {
      GridMap map = SmartSensing.map(answer.read(client.query(request.bytes(AREA), PATIENCE)),
          shared.frames().map());
      shared.pulse().heard(System.nanoTime());
      return Optional.of(map);
    } catch (MessageException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  @Override
  public void close() {
    client.close();
  }
}
