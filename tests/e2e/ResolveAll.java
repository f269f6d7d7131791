import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.stream.Stream;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleContext;
import org.osgi.framework.Constants;
import org.osgi.framework.launch.Framework;
import org.osgi.framework.launch.FrameworkFactory;
import org.osgi.framework.wiring.FrameworkWiring;

/**
 * Puts all bundles of a folder into an empty framework and prints those that cannot be resolved. Run from its source.
 */
final class ResolveAll {

  private ResolveAll() {}

  public static void main(String[] arguments) throws Exception {
    Path storage = Files.createTempDirectory("resolve-all");
    Framework framework = ServiceLoader.load(FrameworkFactory.class).findFirst().orElseThrow()
        .newFramework(Map.of(Constants.FRAMEWORK_STORAGE, storage.toString()));
    framework.init();
    install(framework.getBundleContext(), new File(arguments[0]));
    framework.adapt(FrameworkWiring.class).resolveBundles(null);
    Stream.of(framework.getBundleContext().getBundles())
        .filter(bundle -> bundle.getState() == Bundle.INSTALLED)
        .forEach(System.out::println);
    framework.stop();
    framework.waitForStop(10_000);
  }

  private static void install(BundleContext context, File folder) throws Exception {
    for (File jar : folder
        .listFiles((parent, name) -> name.endsWith(".jar") && !name.startsWith("org.eclipse.osgi_"))) {
      context.installBundle(jar.toURI().toString());
    }
  }
}
