// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_MUTE_SUBSCRIBER_H
#define PARALLEL_ASPECTS_TEST_ROS_MUTE_SUBSCRIBER_H

#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>

#include <XmlRpc.h>
#include <arpa/inet.h>
#include <cstdint>
#include <cstring>
#include <netdb.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>

namespace parallel_aspects::test {

/// Subscribes to a topic of a node by hand, over TCPROS, and never reads a byte.
class MuteSubscriber {
 public:
  MuteSubscriber(const std::string& node, const std::string& topic) {
    XmlRpc::XmlRpcValue request, response, payload;
    request[0] = ros::this_node::getName();
    request[1] = node;
    std::uint32_t port = 0;
    std::string host;
    if (!ros::master::execute("lookupNode", request, response, payload, false)) return;
    if (!ros::network::splitURI(static_cast<std::string>(payload), host, port)) return;
    XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
    XmlRpc::XmlRpcValue ask, answer;
    ask[0] = ros::this_node::getName();
    ask[1] = topic;
    ask[2][0][0] = "TCPROS";
    if (!client.execute("requestTopic", ask, answer) || answer[2].size() < 3) return;
    connect_to(static_cast<std::string>(answer[2][1]), static_cast<int>(answer[2][2]), topic);
  }
  ~MuteSubscriber() {
    if (socket_ >= 0) close(socket_);
  }
  MuteSubscriber(const MuteSubscriber&) = delete;
  MuteSubscriber& operator=(const MuteSubscriber&) = delete;

  bool connected() const noexcept { return connected_; }

 private:
  void connect_to(const std::string& host, int port, const std::string& topic) {
    addrinfo hints{}, *found = nullptr;
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_STREAM;
    if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) return;
    socket_ = socket(AF_INET, SOCK_STREAM, 0);
    const int small = 4096;
    setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
    connected_ = connect(socket_, found->ai_addr, found->ai_addrlen) == 0 && send_header(topic);
    freeaddrinfo(found);
  }

  bool send_header(const std::string& topic) {
    std::string fields;
    for (const std::string& field : {std::string("callerid=/mute"), "topic=" + topic, std::string("type=*"),
                                     std::string("md5sum=*"), std::string("tcp_nodelay=0")})
      fields += length_of(field) + field;
    const std::string header = length_of(fields) + fields;
    return send(socket_, header.data(), header.size(), 0) == static_cast<ssize_t>(header.size());
  }

  static std::string length_of(const std::string& text) {
    const auto length = static_cast<std::uint32_t>(text.size());
    std::string bytes(sizeof length, '\0');
    std::memcpy(bytes.data(), &length, sizeof length);
    return bytes;
  }

  int socket_ = -1;
  bool connected_ = false;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_MUTE_SUBSCRIBER_H
