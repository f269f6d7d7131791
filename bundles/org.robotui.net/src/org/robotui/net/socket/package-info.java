/**
 * TCP sockets of clients and servers: addresses, options, reading against a deadline, accepting, and closing all at
 * once. What blocks says so; closing a socket from another thread ends whatever blocks on it with an
 * {@link java.io.IOException}. Times are {@link java.time.Duration}s; a time that is over is a
 * {@link java.net.SocketTimeoutException}.
 */
@org.osgi.annotation.versioning.Version("1.2.0")
package org.robotui.net.socket;
