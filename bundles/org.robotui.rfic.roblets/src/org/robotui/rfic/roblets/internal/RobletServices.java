package org.robotui.rfic.roblets.internal;

import static org.osgi.service.component.annotations.ReferenceScope.PROTOTYPE;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import org.osgi.service.component.ComponentServiceObjects;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Deactivate;
import org.osgi.service.component.annotations.Reference;
import org.osgi.service.component.annotations.ReferenceCardinality;
import org.osgi.service.component.annotations.ReferencePolicy;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletOptions;
import org.robotui.roblets.roblet.RobletRunner;
import org.robotui.roblets.wire.BodyDatagram;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs the roblets that bundles register as services: each from when it comes until it goes. One that fails is started
 * again, by another instance where its service makes one for each that asks (prototype scope), else by the same.
 */
@Component(service = {}, immediate = true)
public final class RobletServices {
  /** A property of such services: where the brain is, in place of what the environment says. */
  static final String BRAIN = "roblets.brain";

  private static final Logger LOG = LoggerFactory.getLogger(RobletServices.class);

  private final Map<ComponentServiceObjects<Roblet>, Running> running = new ConcurrentHashMap<>();

  private record Running(RobletRunner runner, Instances instances) {}

  @Reference(cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC, scope = PROTOTYPE)
  void addRoblet(ComponentServiceObjects<Roblet> service) {
    Instances instances = new Instances(service);
    try {
      running.put(service, new Running(new RobletRunner(instances, options(service)), instances));
    } catch (IOException | RuntimeException e) {
      instances.giveBack();
      LOG.error("the roblet of {} cannot be run", service.getServiceReference().getBundle(), e);
    }
  }

  private static RobletOptions options(ComponentServiceObjects<Roblet> service) throws IOException {
    Map<String, String> variables = new HashMap<>(System.getenv());
    if (service.getServiceReference().getProperty(BRAIN) instanceof String told) {
      variables.put(BodyDatagram.BRAIN_VARIABLE, told);
    }
    return RobletOptions.of(Thread.ofPlatform().daemon().factory(), variables);
  }

  void removeRoblet(ComponentServiceObjects<Roblet> service) {
    Running each = running.remove(service);
    if (each != null) {
      each.runner().close();
      each.instances().giveBack();
    }
  }

  @Deactivate
  void deactivate() {
    running.keySet().forEach(this::removeRoblet);
  }

  /** Gives the instance before back when the next is asked for; the last goes back with its service. */
  private static final class Instances implements Supplier<Roblet> {
    private final ComponentServiceObjects<Roblet> service;
    private Roblet last; // guarded by this

    Instances(ComponentServiceObjects<Roblet> service) {
      this.service = service;
    }

    @Override
    public synchronized Roblet get() {
      giveBack();
      last = service.getService();
      if (last == null) {
        throw new IllegalStateException("the service is gone");
      }
      return last;
    }

    synchronized void giveBack() {
      if (last != null) {
        service.ungetService(last);
        last = null;
      }
    }
  }
}
