package org.robotui.bridge.internal;

import java.util.List;
import java.util.Optional;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Deactivate;
import org.osgi.service.component.annotations.Reference;
import org.osgi.service.component.annotations.ReferenceCardinality;
import org.osgi.service.component.annotations.ReferencePolicy;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.BridgeTransform;
import org.robotui.api.bridge.Bridges;
import org.robotui.api.host.Host;
import org.robotui.bridge.internal.carry.BridgeRunner;

/** The bridges as an OSGi service. It is loaded when somebody asks for it. */
@Component(service = Bridges.class)
public final class BridgesComponent implements Bridges {
  private final Host host;
  private final TransformTable transforms = new TransformTable();
  private Optional<BridgeRunner> runner = Optional.empty();

  /** Called by declarative services. */
  @Activate
  public BridgesComponent(@Reference Host host) {
    this.host = host;
  }

  @Reference(cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC, unbind = "removeTransform")
  void addTransform(BridgeTransform transform) {
    transforms.add(transform);
  }

  void removeTransform(BridgeTransform transform) {
    transforms.remove(transform);
  }

  @Override
  public synchronized void start() {
    if (runner.isEmpty()) {
      runner = Optional.of(new BridgeRunner(host, transforms));
    }
  }

  @Override
  @Deactivate
  public synchronized void stop() {
    runner.ifPresent(BridgeRunner::close);
    runner = Optional.empty();
  }

  @Override
  public synchronized List<BridgeStatus> statuses() {
    return runner.map(BridgeRunner::statuses).orElse(List.of());
  }
}
