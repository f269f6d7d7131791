package org.robotui.ros.internal.xmlrpc;

import java.time.Duration;

/** What an XML-RPC client or server waits for and accepts at most. */
public record XmlRpcLimits(Duration connect, Duration message, Duration idle, int maxBody, int maxConnections) {

    public static XmlRpcLimits standard() {
        return new XmlRpcLimits(Duration.ofSeconds(3), Duration.ofSeconds(10), Duration.ofSeconds(60), 16 << 20, 512);
    }

    public XmlRpcLimits withMessage(Duration time) {
        return new XmlRpcLimits(connect, time, idle, maxBody, maxConnections);
    }
}
