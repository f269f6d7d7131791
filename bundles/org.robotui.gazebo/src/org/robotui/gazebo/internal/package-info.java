/** Discovery by multicast, and the sockets of ZeroMQ on which messages, requests and responses come and go. */
package org.robotui.gazebo.internal;
