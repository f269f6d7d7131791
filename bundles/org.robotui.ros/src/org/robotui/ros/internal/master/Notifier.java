package org.robotui.ros.internal.master;

import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.io.Closeables;
import org.robotui.ros.internal.io.HostPort;
import org.robotui.ros.internal.io.Workers;
import org.robotui.ros.internal.xmlrpc.XmlRpcClient;
import org.robotui.ros.internal.xmlrpc.XmlRpcFault;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Calls nodes back. Each node has a queue, and a thread while there is something in it, so that a node that hangs holds
 * up nobody else. Of several updates of one topic or parameter that wait only the newest is sent.
 */
final class Notifier {

    private static final Logger LOG = LoggerFactory.getLogger(Notifier.class);

    /** What a node is to be told, and what makes a newer message replace an older one. */
    record Message(String method, String subject, List<XmlRpcValue> arguments) {

        String key() {
            return method + " " + subject;
        }
    }

    private final Workers workers;
    private final Closeables open = new Closeables();
    private final Map<String, Map<String, Message>> waiting = new HashMap<>();

    Notifier(Workers workers) {
        this.workers = workers;
    }

    void publisherUpdate(String uri, String topic, List<String> publishers) {
        send(uri, new Message("publisherUpdate", topic,
                List.of(XmlRpcValue.of("/master"), XmlRpcValue.of(topic), XmlRpcValue.ofTexts(publishers))));
    }

    void paramUpdate(String uri, String key, XmlRpcValue value) {
        send(uri, new Message("paramUpdate", key, List.of(XmlRpcValue.of("/master"), XmlRpcValue.of(key), value)));
    }

    void shutdown(String uri, String reason) {
        send(uri, new Message("shutdown", "", List.of(XmlRpcValue.of("/master"), XmlRpcValue.of(reason))));
    }

    private synchronized void send(String uri, Message message) {
        Optional<Map<String, Message>> queue = Optional.ofNullable(waiting.get(uri));
        queue.ifPresentOrElse(known -> replace(known, message), () -> {
            Map<String, Message> fresh = new LinkedHashMap<>();
            replace(fresh, message);
            waiting.put(uri, fresh);
            workers.start("ros master to " + uri, () -> drain(uri));
        });
    }

    /** A newer message goes to the end: parameters of one namespace must not overtake each other. */
    private static void replace(Map<String, Message> queue, Message message) {
        queue.remove(message.key());
        queue.put(message.key(), message);
    }

    private void drain(String uri) {
        try (XmlRpcClient client = new XmlRpcClient(HostPort.ofUri(uri, "http"), XmlRpcLimits.standard())) {
            open.add(client);
            for (Optional<Message> next = poll(uri); next.isPresent(); next = poll(uri)) {
                call(client, next.get());
            }
            open.forget(client);
        } catch (IllegalArgumentException e) {
            LOG.warn("cannot tell a node anything: {}", e.getMessage());
            forget(uri);
        }
    }

    private synchronized Optional<Message> poll(String uri) {
        Map<String, Message> queue = waiting.get(uri);
        Optional<Message> next = queue.values().stream().findFirst();
        next.ifPresentOrElse(message -> queue.remove(message.key()), () -> waiting.remove(uri));
        return next;
    }

    private synchronized void forget(String uri) {
        waiting.remove(uri);
    }

    private static void call(XmlRpcClient client, Message message) {
        try {
            client.call(message.method(), message.arguments());
        } catch (IOException | XmlRpcFault e) {
            LOG.debug("{} of {} did not reach {}: {}", message.method(), message.subject(), client.target(), e.getMessage());
        }
    }

    void close() {
        open.close();
    }
}
