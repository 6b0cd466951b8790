// npm run mock [-- PORT [ROBOTS]]: the page with pretended runs, to look at.
import { start_mock } from './server.mjs';

const [port = '8090', robots = '6'] = process.argv.slice(2);
const mock = await start_mock({ port: Number(port), robots: Number(robots) });
console.log(mock.url);
setInterval(() => {}, 1 << 30);
