package org.robotui.core.internal.host;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.osgi.framework.BundleContext;
import org.osgi.framework.FrameworkUtil;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Deactivate;
import org.osgi.service.component.annotations.Reference;
import org.osgi.service.component.annotations.ReferenceCardinality;
import org.osgi.service.component.annotations.ReferencePolicy;
import org.robotui.api.ComponentType;
import org.robotui.api.RficType;
import org.robotui.api.RuicType;
import org.robotui.api.UicType;
import org.robotui.api.UicType.Surface;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Setting;
import org.robotui.api.host.CheckReport;
import org.robotui.api.host.Composition;
import org.robotui.api.host.ConfigSettings;
import org.robotui.api.host.FileOpener;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Installed;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Problem;
import org.robotui.api.host.ReuseReport;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.WindowConfig;
import org.robotui.api.time.PointedTime;
import org.robotui.core.internal.config.SchemaCheck;
import org.robotui.core.internal.config.YamlConfigSource;
import org.robotui.core.internal.config.YamlOverlay;
import org.robotui.core.internal.life.Registry;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.core.internal.time.WallClock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The core as an OSGi service. The only place that tracks component types as they come and go. */
@Component(service = Host.class, immediate = true)
public final class CoreComponent implements Host {
  private static final Logger LOG = LoggerFactory.getLogger(CoreComponent.class);
  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(2);
  private static final Duration REMOVAL_LIMIT = Duration.ofSeconds(3);

  private final Registry registry = new Registry();
  private final Core core;

  /** Called by declarative services. */
  @Activate
  public CoreComponent(BundleContext context) {
    StateFolder state = StateFolder.of(System.getProperties(), System.getenv());
    LOG.info("RobotUI {}, Java {} ({}), {} {} on {}, {} processors, {} MB for Java, state in {}",
        context.getBundle().getVersion(),
        System.getProperty("java.version"), System.getProperty("java.home"), System.getProperty("os.name"),
        System.getProperty("os.version"),
        System.getProperty("os.arch"), Runtime.getRuntime().availableProcessors(),
        Runtime.getRuntime().maxMemory() >> 20, state.path());
    core = new Core(new CoreParts(registry, new YamlConfigSource(System.getenv()), new SchemaCheck(), new YamlOverlay(),
        state, new OsgiBundleNames(context), NanoClock.SYSTEM,
        WallClock.SYSTEM));
  }

  @Deactivate
  void deactivate() {
    core.close(CLOSE_LIMIT).forEach(left -> LOG.warn("{}", left));
  }

  @Reference(cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC, unbind = "removeRfic")
  void addRfic(RficType type) {
    registry.add(type, bundle(type));
  }

  void removeRfic(RficType type) {
    await(type, registry.remove(type));
  }

  @Reference(cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC, unbind = "removeUic")
  void addUic(UicType type) {
    registry.add(type, bundle(type));
  }

  void removeUic(UicType type) {
    await(type, registry.remove(type));
  }

  @Reference(cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC, unbind = "removeRuic")
  void addRuic(RuicType type) {
    registry.add(type, bundle(type));
  }

  void removeRuic(RuicType type) {
    await(type, registry.remove(type));
  }

  /** Once a service is given back its bundle may lose its classes: so its instances end before. */
  private static void await(ComponentType type, CompletableFuture<Void> removal) {
    try {
      removal.get(REMOVAL_LIMIT.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException | ExecutionException e) {
      LOG.warn("What the type of {} made has not ended while its bundle {} goes", type.getClass().getName(),
          bundle(type), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static String bundle(ComponentType type) {
    return FrameworkUtil.getBundle(type.getClass()).getSymbolicName();
  }

  @Override
  public void open(Surface surface, Principal principal) {
    core.open(surface, principal);
  }

  @Override
  public List<Problem> load(Path file) {
    return core.load(file);
  }

  @Override
  public CheckReport check(Path file, Duration wait) {
    return core.check(file, wait);
  }

  @Override
  public List<Installed> installed() {
    return core.installed();
  }

  @Override
  public ReuseReport reuse() {
    return core.reuse();
  }

  @Override
  public Optional<String> wrong(Setting setting, Object value) {
    return core.wrong(setting, value);
  }

  @Override
  public List<Ruic> ruics() {
    return core.ruics();
  }

  @Override
  public List<WindowConfig> windows() {
    return core.windows();
  }

  @Override
  public List<BridgeConfig> bridges() {
    return core.bridges();
  }

  @Override
  public Composition compose(InterfaceConfig wanted) {
    return core.compose(wanted);
  }

  @Override
  public FileOpener files() {
    return core.files();
  }

  @Override
  public PointedTime pointed() {
    return core.pointed();
  }

  @Override
  public ConfigSettings settings() {
    return core.settings();
  }

  @Override
  public Subscription listen(HostListener listener) {
    return core.listen(listener);
  }

  @Override
  public Subscription listen(HostListener listener, Executor executor) {
    return core.listen(listener, executor);
  }

  @Override
  public void displayAlive() {
    core.displayAlive();
  }

  @Override
  public void displayFocused(boolean focused) {
    core.displayFocused(focused);
  }

  @Override
  public List<String> support(Path file) throws IOException {
    return core.support(file);
  }

  @Override
  public Map<Path, String> configurationTexts() {
    return core.configurationTexts();
  }

  @Override
  public void stopAll(Principal by) {
    core.stopAll(by);
  }

  @Override
  public Duration closeLimit(Duration limit) {
    return core.closeLimit(limit);
  }

  @Override
  public List<String> close(Duration limit) {
    return core.close(limit);
  }
}
