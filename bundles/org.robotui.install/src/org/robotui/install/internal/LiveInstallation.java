package org.robotui.install.internal;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.eclipse.equinox.internal.provisional.configurator.Configurator;
import org.osgi.framework.BundleContext;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Deactivate;
import org.osgi.service.component.annotations.Reference;
import org.osgi.service.component.annotations.ReferenceCardinality;
import org.osgi.service.component.annotations.ReferencePolicy;
import org.robotui.install.InstallListener;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps the running application as the product and the user's folder of bundles are. The folder is looked at once
 * before anybody reads a configuration, so that what lies there is there from the start.
 */
@SuppressWarnings("restriction") // the one who applies the installer's list has no public interface
@Component(service = LiveInstallation.class, immediate = true)
public final class LiveInstallation {
  private static final Logger LOG = LoggerFactory.getLogger(LiveInstallation.class);
  private static final int PERIOD_MILLIS = 500;
  private static final String FOLDER = "robotui.bundles";
  private static final String COPIES = "robotui.bundles.copies";

  private final List<InstallListener> listeners = new CopyOnWriteArrayList<>();
  private final Optional<BundleFolder> folder;
  private volatile List<String> troubles = List.of();
  private final Optional<ProductBundles> product;
  private final ScheduledExecutorService watch = Executors
      .newSingleThreadScheduledExecutor(task -> Thread.ofPlatform().daemon().name("installed-bundles").unstarted(task));

  /** Called by declarative services; there is no configurator where no installer has made the product. */
  @Activate
  public LiveInstallation(BundleContext context,
      @Reference(cardinality = ReferenceCardinality.OPTIONAL) Configurator configurator) {
    Framework framework = new Framework(context);
    product = product(configurator, framework);
    folder = property(FOLDER).flatMap(watched -> property(COPIES)
        .map(copies -> new BundleFolder(watched, copies, framework, this::said)));
    try {
      if (folder.isPresent()) {
        folder.get().clear();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    look();
    if (folder.isPresent() || product.isPresent()) {
      watch.scheduleWithFixedDelay(this::look, PERIOD_MILLIS, PERIOD_MILLIS, TimeUnit.MILLISECONDS);
    }
  }

  private static Optional<Path> property(String name) {
    return Optional.ofNullable(System.getProperty(name)).filter(text -> !text.isBlank()).map(Path::of);
  }

  private static Optional<ProductBundles> product(Configurator configurator, Framework framework) {
    if (configurator == null || configurator.getUrlInUse() == null) {
      return Optional.empty();
    }
    try {
      return Optional.of(new ProductBundles(configurator, framework));
    } catch (IOException e) {
      LOG.warn("What is installed later needs a new start: {} cannot be read: {}", configurator.getUrlInUse(),
          e.toString());
      return Optional.empty();
    }
  }

  /** Called by declarative services. */
  @Deactivate
  public void deactivate() {
    watch.shutdown();
    synchronized (this) {
      folder.ifPresent(BundleFolder::close);
    }
  }

  @Reference(cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC, unbind = "removeListener")
  void addListener(InstallListener listener) {
    listeners.add(listener);
    troubles.forEach(sentence -> listener.said(sentence, true));
  }

  void removeListener(InstallListener listener) {
    listeners.remove(listener);
  }

  /**
   * Takes up what this process has installed.
   *
   * @return true where that needs a new start
   */
  synchronized boolean apply() throws IOException {
    if (product.isEmpty()) {
      return true;
    }
    boolean restart = product.get().apply().restart();
    look();
    return restart;
  }

  private synchronized void look() {
    try {
      if (product.isPresent() && product.get().isChanged()) {
        tell(product.get().apply());
      }
      if (folder.isPresent()) {
        folder.get().scan();
        troubles = folder.get().troubles();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException | RuntimeException e) {
      LOG.warn("What was installed or removed could not be taken up", e);
    }
  }

  private void tell(ProductBundles.Applied change) {
    if (change.restart()) {
      said("RobotUI was updated. It takes effect when it is started again.", false);
    } else if (!change.isNothing()) {
      said(String.join(" ", names("Installed", change.come()), names("Removed", change.gone())).strip(), false);
    }
  }

  private static String names(String verb, Set<BundleList.Entry> entries) {
    return entries.isEmpty() ? ""
        : entries.stream().map(entry -> entry.name() + " " + entry.version()).sorted()
            .collect(Collectors.joining(", ", verb + " ", "."));
  }

  private void said(String sentence, boolean trouble) {
    if (trouble) {
      LOG.warn("{}", sentence);
    } else {
      LOG.info("{}", sentence);
    }
    listeners.forEach(listener -> listener.said(sentence, trouble));
  }
}
